#include "hdf5_image.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "output/versions.h"
#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

void require(herr_t status) {
  if (status < 0) throw std::runtime_error("HDF5 refuses to write in memory");
}

void require_finite(const std::string& path, const double* values, std::size_t n) {
  if (!std::all_of(values, values + n, [](double value) { return std::isfinite(value); }))
    throw NumericsError("'" + path + "' holds a number that is not finite; nothing was written");
}

hid_t in_memory() {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  constexpr std::size_t growth = 1 << 20;
  require(H5Pset_fapl_core(access, growth, false));
  return access;
}

hid_t with_groups_on_the_way() {
  const hid_t links = H5Pcreate(H5P_LINK_CREATE);
  require(H5Pset_create_intermediate_group(links, 1));
  return links;
}

/// Leaves out the time of day, so that equal numbers make equal bytes.
hid_t without_clock() {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  require(H5Pset_obj_track_times(creation, false));
  return creation;
}

/// The same of a dataset that is compressed as a whole; of one without numbers, which has nothing to compress, the
/// same.
hid_t packed_in_one(const std::vector<hsize_t>& shape) {
  const hid_t creation = without_clock();
  if (std::find(shape.begin(), shape.end(), hsize_t{0}) != shape.end()) return creation;
  constexpr unsigned level = 6;
  require(H5Pset_chunk(creation, static_cast<int>(shape.size()), shape.data()));
  require(H5Pset_shuffle(creation));
  require(H5Pset_deflate(creation, level));
  return creation;
}

/// A string of `size` bytes, or H5T_VARIABLE.
hid_t text_type(std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  require(H5Tset_size(type, size));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

void set_attribute(hid_t object, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute, type, value));
}

void set_attribute(hid_t object, const std::string& name, const std::string& text) {
  set_attribute(object, name, Handle(text_type(text.size() + 1), H5Tclose), text.c_str());
}

}  // namespace

Hdf5Image::Hdf5Image(const std::string& title)
    : access_(in_memory(), H5Pclose),
      file_(H5Fcreate("image.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access_), H5Fclose),
      links_(with_groups_on_the_way(), H5Pclose),
      creation_(without_clock(), H5Pclose) {
  attribute("/", "title", title);
  attribute("/", "program", std::string(program_version()));
  attribute("/", "versions", versions_line());
}

void Hdf5Image::attribute(const std::string& object, const std::string& name, const std::string& text) {
  set_attribute(Handle(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose), name, text);
  checksum_.add({object, name}, text);
}

void Hdf5Image::attribute(const std::string& object, const std::string& name, double number) {
  require_finite(object + "/" + name, &number, 1);
  set_attribute(Handle(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose), name, H5T_NATIVE_DOUBLE, &number);
  checksum_.add({object, name}, number);
}

void Hdf5Image::attribute(const std::string& object, const std::string& name, int number) {
  set_attribute(Handle(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose), name, H5T_NATIVE_INT, &number);
  checksum_.add({object, name}, static_cast<double>(number));
}

void Hdf5Image::group(const std::string& path) {
  const Handle made(H5Gcreate2(file_, path.c_str(), links_, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
}

void Hdf5Image::numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                        const Label& label) {
  require_finite(path, values,
                 std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<std::size_t>()));
  write_numbers(path, shape, values, label);
}

void Hdf5Image::numbers_or_none(const std::string& path, const std::vector<double>& values, const Label& label) {
  if (std::any_of(values.begin(), values.end(), [](double value) { return std::isinf(value); }))
    throw NumericsError("'" + path + "' holds a number that is infinite; nothing was written");
  write_numbers(path, {values.size()}, values.data(), label);
}

void Hdf5Image::packed_numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                               const Label& label) {
  const auto n = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<std::size_t>());
  require_finite(path, values, n);
  const auto [at, is_new] = packed_.try_emplace({shape, {values, values + n}, label.unit, label.description}, path);
  if (is_new) return write_numbers(path, shape, values, label, Handle(packed_in_one(shape), H5Pclose));
  require(H5Lcreate_hard(file_, at->second.c_str(), file_, path.c_str(), links_, H5P_DEFAULT));
  checksum_.add(path, {shape.begin(), shape.end()}, values);
  checksum_.add({path, "unit"}, label.unit);
  checksum_.add({path, "description"}, label.description);
}

void Hdf5Image::write_numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                              const Label& label) {
  write_numbers(path, shape, values, label, creation_);
}

void Hdf5Image::write_numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                              const Label& label, hid_t creation) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Handle data(H5Dcreate2(file_, path.c_str(), H5T_NATIVE_DOUBLE, space, links_, creation, H5P_DEFAULT), H5Dclose);
  require(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  attribute(path, "unit", label.unit);
  attribute(path, "description", label.description);
  checksum_.add(path, {shape.begin(), shape.end()}, values);
}

void Hdf5Image::texts(const std::string& path, const std::vector<std::string>& values) {
  std::vector<const char*> pointers;
  for (const std::string& value : values) pointers.push_back(value.c_str());
  const Handle type(text_type(H5T_VARIABLE), H5Tclose);
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle data(H5Dcreate2(file_, path.c_str(), type, space, links_, creation_, H5P_DEFAULT), H5Dclose);
  require(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()));
  checksum_.add(path, values);
}

void Hdf5Image::text(const std::string& path, const std::string& value) {
  const Handle type(text_type(value.size() + 1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle data(H5Dcreate2(file_, path.c_str(), type, space, links_, creation_, H5P_DEFAULT), H5Dclose);
  require(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.c_str()));
  checksum_.add(path, std::vector<std::string>{value});
}

void Hdf5Image::seal() {
  attribute("/", checksum_name, checksum_.value());
}

std::string Hdf5Image::bytes() const {
  require(H5Fflush(file_, H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
  if (size < 0) throw std::runtime_error("HDF5 gives no image of its file");
  std::string image(static_cast<std::size_t>(size), '\0');
  H5Fget_file_image(file_, image.data(), image.size());
  return image;
}

}  // namespace upbead::detail
