// An HDF5 identifier that closes itself.
#pragma once

#include <hdf5.h>

#include <stdexcept>

namespace upbead::detail {

/// An identifier with the function that closes it. One that is negative, HDF5's word for failure, is a bug where a file
/// is made (the constructor throws) and a question where one is read (see `maybe`).
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 refuses to make an object");
  }
  /// One that may be negative: then nothing is closed.
  static Handle maybe(hid_t id, herr_t (*close)(hid_t)) { return Handle(id, id < 0 ? nullptr : close, 0); }
  ~Handle() {
    if (close_ != nullptr) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  Handle(hid_t id, herr_t (*close)(hid_t), int) : id_(id), close_(close) {}

  hid_t id_;
  herr_t (*close_)(hid_t);
};

}  // namespace upbead::detail
