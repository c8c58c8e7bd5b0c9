#include "upbead/output/result_file.h"

#include <hdf5.h>

#include <cmath>
#include <stdexcept>

#include "upbead/base/error.h"
#include "upbead/base/version.h"

namespace upbead {

namespace {

/// An HDF5 identifier with the function that closes it.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 refuses to make an object in memory");
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status) {
  if (status < 0) throw std::runtime_error("HDF5 refuses to write in memory");
}

void set_attribute(hid_t object, const char* name, const std::string& value) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, value.size() + 1));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, type, value.c_str()));
}

void write_history(hid_t file, const History& history) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  require(H5Pset_create_intermediate_group(links, 1));
  const hsize_t size = history.values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const std::string path = "/history/" + history.name;
  const Handle data(H5Dcreate2(file, path.c_str(), H5T_NATIVE_DOUBLE, space, links, H5P_DEFAULT, H5P_DEFAULT),
                    H5Dclose);
  require(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, history.values.data()));
  set_attribute(data, "unit", history.unit);
  set_attribute(data, "description", history.description);
}

/// The bytes of the file as it would stand on a disk.
std::string image_of(hid_t file) {
  require(H5Fflush(file, H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) throw std::runtime_error("HDF5 gives no image of its file");
  std::string image(static_cast<std::size_t>(size), '\0');
  H5Fget_file_image(file, image.data(), image.size());
  return image;
}

}  // namespace

std::string result_file(const std::string& title, const std::vector<History>& histories) {
  for (const History& history : histories)
    for (const double value : history.values)
      if (!std::isfinite(value))
        throw NumericsError("the history '" + history.name +
                            "' holds a number that is not finite; nothing was written");
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t growth = 1 << 20;
  require(H5Pset_fapl_core(access, growth, 0));
  const Handle file(H5Fcreate("results.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  set_attribute(file, "title", title);
  set_attribute(file, "program", program_version());
  for (const History& history : histories) write_history(file, history);
  return image_of(file);
}

}  // namespace upbead
