// The keys of a JSON object that is written, each declared once: name, member, unit, meaning. From the declaration
// follow the object, the tables of docs (`upbead explain --outputs`), and units and labels in Python.
//
//   OutputSchema<Timing> schema;
//   schema.key("total", &Timing::total, "s", "since the start of the program");
//
// An access is a pointer to a member or a function of the object. An optional value that is absent is written as
// null. "slips[]" names a list, "loads.NAME" an object with a key for each name. A meaning is Markdown, with links as
// in docs; its part before the first ": " or "; " also serves as a label.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "output/versions.h"
#include "upbead/base/numbered_warning.h"

namespace upbead {

using Json = nlohmann::ordered_json;

/// The text, indented (one_line: not at all), with a final newline. JSON cannot express a number that is not finite:
/// throws NumericsError with its path.
constexpr int one_line = -1;
std::string json_text(const Json& json, int indent = 2);

struct OutputRow {
  std::string path;  ///< "response.peak_shear", "sliding.slips[].start", "loads.NAME.arm"
  std::string unit;  ///< "" where it has none
  std::string meaning;
  bool is_number = false;  ///< a number or null
};

/// Tables with key, unit and meaning; an object with many keys gets a table of its own under a heading.
std::string markdown(const std::vector<OutputRow>& rows);

/// The common part of all schemas.
class OutputKeys {
 public:
  struct Entry {
    std::vector<OutputRow> rows;  ///< its own, then those of the objects inside
    std::function<Json(const void*)> value;
  };
  const std::vector<Entry>& entries() const { return entries_; }
  std::vector<OutputRow> rows() const;

 protected:
  void add(const OutputRow& row, std::function<Json(const void*)> value, const OutputKeys* inside);
  void add(const Entry& entry) { entries_.push_back(entry); }
  /// Leaves out the last key where it is null, or an object without keys.
  void leave_out_null();
  Json object(const void* of) const;

 private:
  std::vector<Entry> entries_;
};

namespace detail {

template <class V>
Json json_of(const V& value) {
  return Json(value);
}
template <class V>
Json json_of(const std::optional<V>& value) {
  return value ? Json(*value) : Json(nullptr);
}
template <class V>
Json json_of(const V* value) {
  return value ? json_of(*value) : Json(nullptr);
}
inline Json json_of(const char* word) {
  return Json(word);
}

template <class V>
constexpr bool is_numeric = std::is_arithmetic_v<V> && !std::is_same_v<V, bool>;
template <class V>
constexpr bool is_numeric<std::optional<V>> = is_numeric<V>;
template <class V>
constexpr bool is_numeric<const V*> = is_numeric<V> && !std::is_same_v<V, char>;

template <class V>
constexpr bool is_optional = false;
template <class V>
constexpr bool is_optional<std::optional<V>> = true;

template <class U>
const U* pointer_to(const U& part) {
  return &part;
}
template <class U>
const U* pointer_to(const std::optional<U>& part) {
  return part ? &*part : nullptr;
}
template <class U>
const U* pointer_to(const U* part) {
  return part;
}
template <class U>
void pointer_to(const U&& part) = delete;

}  // namespace detail

/// Access to a member of a member, and so on; a member may be a pointer. Behind one that is optional there is a
/// pointer, or an optional value of a function, null where it is absent.
template <class First, class... Further>
auto inner(First first, Further... further) {
  return [first, further...](const auto& of) -> decltype(auto) {
    using Part = std::invoke_result_t<First, decltype(of)>;
    if constexpr (sizeof...(further) == 0) {
      return std::invoke(first, of);
    } else if constexpr (detail::is_optional<std::decay_t<Part>>) {
      const auto& part = std::invoke(first, of);
      using Value = decltype(inner(further...)(*part));
      if constexpr (std::is_reference_v<Value>)
        return part ? &inner(further...)(*part) : nullptr;
      else
        return part ? std::optional(inner(further...)(*part)) : std::nullopt;
    } else {
      return inner(further...)(std::invoke(first, of));
    }
  };
}

template <class T>
class OutputSchema : public OutputKeys {
 public:
  /// A number, a word, a flag, an array, or Json.
  template <class Access>
  OutputSchema& key(const std::string& name, Access access, const std::string& unit, const std::string& meaning) {
    using V = std::decay_t<std::invoke_result_t<Access, const T&>>;
    return put({name, unit, meaning, detail::is_numeric<V>},
               [access](const T& of) { return detail::json_of(std::invoke(access, of)); });
  }
  /// Words; null where the text is empty.
  OutputSchema& reason(const std::string& name, std::string T::*member, const std::string& meaning) {
    return put({name, "", meaning}, [member](const T& of) { return (of.*member).empty() ? Json() : Json(of.*member); });
  }
  /// `access` gives a U, an optional U, or a pointer, which is null where there is no U.
  template <class Access, class U>
  OutputSchema& object(const std::string& name, Access access, const OutputSchema<U>& inside,
                       const std::string& meaning) {
    const auto value = [access, inside](const T& of) {
      const U* part = detail::pointer_to(std::invoke(access, of));
      return part ? inside.to_json(*part) : Json();
    };
    return put({name, "", meaning}, value, &inside);
  }
  /// The keys of a part as if they were keys of the object; all null where there is no such part.
  template <class Access, class U>
  OutputSchema& keys_of(Access access, const OutputSchema<U>& part) {
    for (const Entry& entry : part.entries())
      add({entry.rows, [access, value = entry.value](const void* of) {
             const U* found = detail::pointer_to(std::invoke(access, *static_cast<const T*>(of)));
             return found ? value(found) : Json();
           }});
    return *this;
  }
  /// Leaves out the last key where it would be null, or an object without keys.
  OutputSchema& or_left_out() {
    leave_out_null();
    return *this;
  }
  /// `access` gives several U.
  template <class Access, class U>
  OutputSchema& list(const std::string& name, Access access, const OutputSchema<U>& inside,
                     const std::string& meaning) {
    const auto value = [access, inside](const T& of) {
      Json items = Json::array();
      for (const U& item : std::invoke(access, of)) items.push_back(inside.to_json(item));
      return items;
    };
    return put({name, "", meaning}, value, &inside);
  }
  /// The same as an object: the key of an item is its `name_of`.
  template <class Access, class Name, class U>
  OutputSchema& named(const std::string& name, Access access, Name name_of, const OutputSchema<U>& inside,
                      const std::string& meaning) {
    const auto value = [access, name_of, inside](const T& of) {
      Json items = Json::object();
      for (const U& item : std::invoke(access, of)) items[std::invoke(name_of, item)] = inside.to_json(item);
      return items;
    };
    return put({name, "", meaning}, value, &inside);
  }

  /// The keys `program` and `versions`, which every summary has.
  OutputSchema& program() {
    return key(
        "program", [](const T&) { return program_version(); }, "", "that wrote it");
  }
  OutputSchema& versions() {
    return key(
        "versions.NAME", [](const T&) { return versions_object(); }, "",
        "of upbead, its compiler and the libraries that numbers go through; an attribute of the same name in "
        "`results.h5` and reduced models");
  }

  Json to_json(const T& of) const { return OutputKeys::object(&of); }
  std::string text(const T& of) const { return json_text(to_json(of)); }

 private:
  template <class Function>
  OutputSchema& put(const OutputRow& row, Function value, const OutputKeys* inside = nullptr) {
    add(
        row, [value](const void* of) { return value(*static_cast<const T*>(of)); }, inside);
    return *this;
  }
};

/// The keys of a warning, the same in every summary.
OutputSchema<NumberedWarning> warning_outputs();
/// A list of such objects.
Json warnings_json(const NumberedWarnings& warnings);

}  // namespace upbead
