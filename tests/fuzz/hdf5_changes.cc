#include "hdf5_changes.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bytes.h"
#include "output/hdf5_image.h"

namespace upbead::fuzz {

namespace {

using detail::Handle;
using Names = std::vector<std::string>;

herr_t add_object(hid_t, const char* name, const H5O_info_t*, void* list) {
  static_cast<Names*>(list)->push_back(std::string("/") + (std::string(name) == "." ? "" : name));
  return 0;
}

/// Opens a copy of the image, in memory.
hid_t with_image(std::string image) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  constexpr std::size_t growth = 1 << 16;
  H5Pset_fapl_core(access, growth, 0);
  H5Pset_file_image(access, image.data(), image.size());
  return access;
}

/// Changes a file in memory. If HDF5 refuses a change, the next one follows.
class Changes {
 public:
  Changes(const std::string& image, std::string_view bytes)
      : bytes_(bytes),
        access_(with_image(image), H5Pclose),
        file_(H5Fopen("image.h5", H5F_ACC_RDWR, access_), H5Fclose) {
    H5Ovisit(file_, H5_INDEX_NAME, H5_ITER_INC, add_object, &objects_);
  }

  std::string run() {
    H5Adelete(file_, "checksum");  // otherwise the checksum would reveal every change
    constexpr int most = 12;
    for (int n = 0; n < most && !bytes_.empty(); ++n) change();
    H5Fflush(file_, H5F_SCOPE_GLOBAL);
    std::string image(static_cast<std::size_t>(std::max<ssize_t>(0, H5Fget_file_image(file_, nullptr, 0))), '\0');
    H5Fget_file_image(file_, image.data(), image.size());
    return image;
  }

 private:
  void change() {
    const std::string& object = any_object();
    switch (bytes_.below(9)) {
      case 0:
        H5Ldelete(file_, object.c_str(), H5P_DEFAULT);
        return;
      case 1:
        H5Ldelete(file_, object.c_str(), H5P_DEFAULT);
        make_numbers(object);
        return;
      case 2:
        H5Ldelete(file_, object.c_str(), H5P_DEFAULT);
        make_texts(object);
        return;
      case 3:
        set_number(object);
        return;
      case 4:
        set_attribute(object);
        return;
      case 5:
        H5Adelete_by_idx(file_, object.c_str(), H5_INDEX_NAME, H5_ITER_INC, static_cast<hsize_t>(bytes_.below(8)),
                         H5P_DEFAULT);
        return;
      case 6:
        H5Lmove(file_, object.c_str(), file_, any_object().c_str(), H5P_DEFAULT, H5P_DEFAULT);
        return;
      case 7:
        make_link(object);
        return;
      default:
        make_shared_size(object);
    }
  }

  const std::string& any_object() { return objects_[bytes_.byte() % objects_.size()]; }

  hid_t any_number_type() {
    static const std::array<hid_t, 6> types{H5T_NATIVE_DOUBLE, H5T_NATIVE_FLOAT, H5T_NATIVE_INT,
                                            H5T_STD_I8BE,      H5T_STD_U64BE,    H5T_IEEE_F64BE};
    return types[static_cast<std::size_t>(bytes_.below(static_cast<int>(types.size())))];
  }

  std::vector<hsize_t> any_shape() {
    static const std::array<hsize_t, 8> large{5, 16, 1 << 10, 1 << 20, hsize_t{1} << 32, hsize_t{1} << 40, 7, 100};
    std::vector<hsize_t> shape(static_cast<std::size_t>(bytes_.below(4)));
    for (hsize_t& size : shape) {
      const int choice = bytes_.below(64);
      size = choice < 56 ? static_cast<hsize_t>(choice % 5) : large[static_cast<std::size_t>(choice - 56)];
    }
    return shape;
  }

  hid_t space_of(const std::vector<hsize_t>& shape) {
    if (bytes_.one_in(32)) return H5Screate(H5S_NULL);
    return H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  }

  /// With values if the dataset is small; otherwise without, which takes no memory.
  void make_numbers(const std::string& path) {
    const std::vector<hsize_t> shape = any_shape();
    const Handle space = Handle::maybe(space_of(shape), H5Sclose);
    if (space < 0) return;
    const Handle data = Handle::maybe(
        H5Dcreate2(file_, path.c_str(), any_number_type(), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    constexpr hssize_t few = 4096;
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    if (data < 0 || n < 0 || n > few) return;
    std::vector<double> values(static_cast<std::size_t>(n) + 1);
    for (double& value : values) value = bytes_.number();
    H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }

  void make_texts(const std::string& path) {
    const std::size_t size = bytes_.one_in(4) ? H5T_VARIABLE : static_cast<std::size_t>(1 + bytes_.below(24));
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, size);
    const hsize_t n = static_cast<hsize_t>(bytes_.below(5));
    const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
    const Handle data =
        Handle::maybe(H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    if (data < 0 || bytes_.one_in(8)) return;
    const std::string text = bytes_.text(static_cast<int>(5 * (size == H5T_VARIABLE ? 24 : size)));
    std::vector<const char*> pointers(static_cast<std::size_t>(n) + 1, text.c_str());
    std::string buffer = text;
    buffer.resize(size == H5T_VARIABLE ? 0 : (n + 1) * size, '\0');
    H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT,
             size == H5T_VARIABLE ? static_cast<const void*>(pointers.data()) : buffer.data());
  }

  /// One number of a dataset.
  void set_number(const std::string& path) {
    const Handle data = Handle::maybe(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (data < 0) return;
    const Handle space(H5Dget_space(data), H5Sclose), type(H5Dget_type(data), H5Tclose);
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    constexpr hssize_t few = 4096;
    if (n <= 0 || n > few || H5Tget_class(type) != H5T_FLOAT) return;
    std::vector<double> values(static_cast<std::size_t>(n));
    H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    values[bytes_.byte() % values.size()] = bytes_.number();
    H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }

  void set_attribute(const std::string& object) {
    static const Names names{"kind",      "format_version",   "title",    "error",       "shift",
                             "friction",  "n_prescribed",     "vectors",  "unit",        "buoyant_weight",
                             "uplift",    "uplift_per_force", "lag",      "end",         "caisson_mass",
                             "tolerance", "solves",           "unknowns", "error_march", "highest_frequency"};
    const std::string& name = names[bytes_.byte() % names.size()];
    H5Adelete_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT);
    const bool is_text = bytes_.one_in(3);
    const std::string text = bytes_.text(is_text ? bytes_.below(24) : 0);
    const std::array<double, 3> values{bytes_.number(), bytes_.number(), bytes_.number()};
    const Handle type(H5Tcopy(is_text ? H5T_C_S1 : H5T_NATIVE_DOUBLE), H5Tclose);
    if (is_text) H5Tset_size(type, text.size() + 1);
    const hsize_t n = is_text || !bytes_.one_in(16) ? 1 : values.size();
    const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
    const Handle attribute = Handle::maybe(
        H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    if (attribute < 0) return;
    H5Awrite(attribute, type, is_text ? static_cast<const void*>(text.c_str()) : values.data());
  }

  void make_link(const std::string& object) {
    H5Ldelete(file_, object.c_str(), H5P_DEFAULT);
    if (bytes_.one_in(4))
      H5Lcreate_external("elsewhere.h5", "/data", file_, object.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    else
      H5Lcreate_soft(any_object().c_str(), file_, object.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }

  /// A list without values, whose length determines the size of other lists.
  void make_shared_size(const std::string& object) {
    H5Ldelete(file_, object.c_str(), H5P_DEFAULT);
    const hsize_t n = hsize_t{1} << bytes_.below(48);
    const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
    const Handle data = Handle::maybe(
        H5Dcreate2(file_, object.c_str(), any_number_type(), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  }

  Bytes bytes_;
  Handle access_, file_;
  Names objects_;
};

}  // namespace

std::string changed_hdf5(const std::string& image, std::string_view bytes) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // HDF5 then prints no message about refused changes
  return Changes(image, bytes).run();
}

std::string sample_waves() {
  detail::Hdf5Image image("waves");
  const std::array<double, 4> time{0., 0.1, 0.2, 0.4}, slow{0., 1e5, 2e5, 0.};
  const std::array<double, 8> impact{0., 1e6, 0., 0., 0., 5e5, 2e5, 0.};
  image.numbers("/time", {4}, time.data(), {"s", "time"});
  image.numbers("/impact", {2, 4}, impact.data(), {"N/m", "P"});
  image.numbers("/slow", {4}, slow.data(), {"N/m", "P"});
  return image.bytes();
}

}  // namespace upbead::fuzz
