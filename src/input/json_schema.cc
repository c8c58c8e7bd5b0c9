// JSON Schema, draft 4: https://json-schema.org/draft-04/json-schema-validation

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "input/schema.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

Json number(const char* type, const Range& range) {
  Json json{{"type", type}};
  if (std::isfinite(range.low())) {
    json["minimum"] = range.low();
    if (!range.low_belongs()) json["exclusiveMinimum"] = true;
  }
  if (std::isfinite(range.high())) {
    json["maximum"] = range.high();
    if (!range.high_belongs()) json["exclusiveMaximum"] = true;
  }
  return json;
}

Json list(Json items, int n) {
  Json json{{"type", "array"}, {"items", std::move(items)}};
  if (n > 0) json["minItems"] = json["maxItems"] = n;
  return json;
}

Json value_of(ValueShape shape, const KeyInfo& info) {
  const Json any = number("number", Range());
  switch (shape) {
    case ValueShape::number:
      // JSON has no infinity: where inf is allowed, the schema allows null too, as a stand-in for it
      return info.range.high_belongs() && std::isinf(info.range.high())
                 ? Json{{"anyOf", {number("number", info.range), {{"type", "null"}}}}}
                 : number("number", info.range);
    case ValueShape::whole_number:
      return number("integer", info.range);
    case ValueShape::truth:
      return {{"type", "boolean"}};
    case ValueShape::text:
      return {{"type", "string"}};
    case ValueShape::number_list:
      return list(number("number", info.range), 0);
    case ValueShape::pair:
      return list(any, 2);
    case ValueShape::pairs:
      return list(list(any, 2), 0);
    case ValueShape::texts:
      return list({{"type", "string"}}, 0);
    case ValueShape::list_or_table:
      return {{"anyOf", {list(any, 0), {{"type", "object"}}}}};
    case ValueShape::list:
      return list(Json::object(), 0);
    case ValueShape::table:
      return {{"type", "object"}};
    case ValueShape::anything:
      return Json::object();
    case ValueShape::numbers:
      return {{"type", "object"}, {"additionalProperties", any}};
  }
  return Json::object();
}

Json words_of(const KeyInfo& info) {
  Json words = info.words;
  for (const auto& [former, now] : info.former_words) words.push_back(former);
  return {{"enum", words}};
}

Json table_of(const Table& table);

/// All kinds of value that a key may have: a value, a word, a table, or tables by name.
Json kinds_of(const Key& key) {
  Json kinds = Json::array();
  if (key.choose) kinds.push_back(words_of(key.info));
  if (key.type) kinds.push_back(value_of(key.type->shape(key.info), key.info));
  if (key.type && !key.info.word.empty()) kinds.push_back({{"enum", {key.info.word}}});
  if (key.table && key.named)
    kinds.push_back({{"type", "object"}, {"additionalProperties", table_of(*key.table)}});
  else if (key.table)
    kinds.push_back(table_of(*key.table));
  return kinds;
}

std::string description_of(const KeyInfo& info) {
  std::string text = info.doc;
  if (!info.unit_of_first.empty()) text += " (first number: " + info.unit_of_first + ")";
  if (!info.unit.empty()) text += " (" + info.unit + ")";
  if (!info.condition.empty()) text += "; only " + info.condition;
  if (!info.fallback.empty()) text += "; default: " + info.fallback;
  return text;
}

/// The default of a value; null where there is none, or JSON cannot express it.
Json default_of(const Key& key, const void* standard) {
  void* object = const_cast<void*>(standard);
  if (key.chosen) {
    const auto word = key.chosen(object);
    return word ? Json(key.info.words[*word]) : Json();
  }
  if (!key.type || key.info.required || !key.info.fallback.empty()) return {};
  return Json::parse(key.type->print(key.info, key.value(object)), nullptr, false);
}

Json property_of(const Key& key, const void* standard) {
  Json kinds = kinds_of(key);
  Json json = kinds.size() == 1 ? kinds[0] : Json{{"anyOf", kinds}};
  json["description"] = description_of(key.info);
  const Json fallback = default_of(key, standard);
  if (!fallback.is_null() && !fallback.is_discarded()) json["default"] = fallback;
  return json;
}

/// The words of a choice with which a key belongs; empty where the word alone does not decide.
Json words_beside(const Table& table, const Key& key, const Key& decisive) {
  Json with = Json::array();
  for (std::size_t i = 0; i < decisive.info.words.size(); ++i) {
    const std::shared_ptr<void> object = table.make();
    decisive.choose(object.get(), i);
    if (key.belongs(object.get())) with.push_back(decisive.info.words[i]);
  }
  for (const auto& [former, now] : decisive.info.former_words)
    if (std::find(with.begin(), with.end(), now) != with.end()) with.push_back(former);
  return with;
}

/// The condition under which a key belongs or is required, by the word of a choice. Written with `dependencies` and
/// `not`, because editors stop completing keys beside an `allOf`.
void add_condition(const Table& table, const Key& key, Json& json) {
  if (!key.belongs) return;
  for (const Key& decisive : table.keys()) {
    if (decisive.info.name != key.decisive || !decisive.choose) continue;
    const Json with = words_beside(table, key, decisive);
    if (with.empty()) return;
    const Json says{{"properties", {{key.decisive, {{"enum", with}}}}}};
    Json told = says;
    told["required"] = {key.decisive};
    const bool by_default = key.belongs(table.make().get());
    json["dependencies"][key.info.name] = by_default ? says : told;
    if (!key.info.required) return;
    Json lacks = by_default ? says : told;
    lacks["not"] = {{"required", {key.info.name}}};
    json["not"]["anyOf"].push_back(lacks);
  }
}

Json table_of(const Table& table) {
  Json json{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
  Json required = Json::array();
  const std::shared_ptr<void> standard = table.make();
  for (const Key& key : table.keys()) {
    json["properties"][key.info.name] = property_of(key, standard.get());
    if (!key.info.former.empty()) {
      Json former = property_of(key, standard.get());
      former["description"] = "older name of " + key.info.name;
      json["properties"][key.info.former] = former;
    }
    if (key.info.required && !key.belongs) required.push_back(key.info.name);
    add_condition(table, key, json);
  }
  for (const std::string& name : table.elsewhere())
    json["properties"][name] = {{"description", "of another command, which reads the same file"}};
  if (!required.empty()) json["required"] = required;
  return json;
}

}  // namespace

std::string json_schema(const Table& table, const std::string& title) {
  Json json{{"$schema", "http://json-schema.org/draft-04/schema#"}, {"title", title}};
  json.update(table_of(table));
  return json.dump(2) + "\n";
}

}  // namespace upbead
