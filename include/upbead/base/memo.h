// What functions make of one value, each called once.
#pragma once

#include <map>
#include <memory>

namespace upbead {

/// Whoever asks first calls the function; as functions may ask for each other, there is no order. Not for several
/// threads.
class Memo {
 public:
  template <class Of, class Value>
  const Value& of(const Of& what, Value (*make)(const Of&)) {
    std::shared_ptr<const void>& made = made_[reinterpret_cast<void (*)()>(make)];
    if (!made) made = std::make_shared<const Value>(make(what));
    return *static_cast<const Value*>(made.get());
  }

 private:
  std::map<void (*)(), std::shared_ptr<const void>> made_;
};

}  // namespace upbead
