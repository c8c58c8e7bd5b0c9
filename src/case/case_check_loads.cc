#include <algorithm>

#include "case_checks.h"
#include "records/gauge_keys.h"

namespace upbead {

namespace {

template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

/// The checks of one load.
class LoadCheck {
 public:
  LoadCheck(const std::string& name, const LoadTable& load, const CaseTables& tables, const Document& document,
            InputReport& report)
      : path_(dotted("loads", name)),
        load_(load),
        tables_(tables),
        document_(document),
        report_(report),
        objections_(path_, document, report) {}

  void run() const {
    exactly_one("boundary", "region");
    if (load_.kind == LoadKind::pressures)
      check_row();
    else
      exactly_one("pulse", "history");
    if (given("boundary")) check_name("boundary", load_.boundary, keys_of(tables_.boundaries), "boundaries");
    if (given("region")) check_region();
    if (load_.kind != LoadKind::pressure && load_.kind != LoadKind::pressures && load_.direction[0] == 0. &&
        load_.direction[1] == 0.)
      objections_.add({"direction", "direction is zero", "give a direction such as [1.0, 0.0]"});
    if (!load_.shape.empty()) check_shape();
    if (load_.pulse && report_.sound(path_ + ".pulse.shape")) check_pulse();
  }

 private:
  bool given(const std::string& key) const { return document_.find(path_ + "." + key) != nullptr; }

  void exactly_one(const std::string& a, const std::string& b) const {
    if (given(a) && given(b)) objections_.add({b, "both '" + a + "' and '" + b + "' are given", "keep one of them"});
    if (!given(a) && !given(b))
      objections_.add({a, "neither '" + a + "' nor '" + b + "' is given", "add " + a + " or " + b});
  }

  bool check_name(const std::string& key, const std::string& name, const std::vector<std::string>& known,
                  const std::string& kind) const {
    if (std::find(known.begin(), known.end(), name) != known.end()) return true;
    objections_.add({key, key + " = " + to_toml(name) + " has no table [" + dotted(kind, name) + "]",
                     suggestion(name, known, kind)});
    return false;
  }

  void check_region() const {
    if (!check_name("region", load_.region, keys_of(tables_.regions), "regions")) return;
    if (report_.sound(dotted("regions", load_.region)) && tables_.regions.at(load_.region).kind != RegionKind::rigid)
      objections_.add({"region", "region = " + to_toml(load_.region) + " is not rigid",
                       "load one of its boundaries instead; only a rigid region takes a load at a point"});
    if (load_.kind != LoadKind::force)
      objections_.add({"kind", "a load on a region is a force, no traction or pressure", "write kind = \"force\""});
  }

  void check_row() const {
    for (const char* key : {"pulse", "history", "shape"})
      if (given(key))
        objections_.add({key, std::string("'") + key + "' does not belong to pressures by transducers",
                         std::string("remove ") + key + ", or write kind = \"pressure\""});
    check_gauges(load_, wall_words, path_, document_, report_);
  }

  void check_shape() const {
    const auto& shape = load_.shape;
    bool ascending = true, all_zero = true;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      ascending = ascending && (i == 0 || shape[i][0] > shape[i - 1][0]);
      all_zero = all_zero && shape[i][1] == 0.;
    }
    if (shape.size() < 2)
      objections_.add({"shape", "one pair of height and intensity makes no shape", "give two pairs or more"});
    if (!ascending) objections_.add({"shape", "the heights of shape do not ascend", "order the pairs by height"});
    if (all_zero) objections_.add({"shape", "every intensity of shape is zero", "give an intensity other than zero"});
  }

  void check_pulse() const {
    for (const Objection& objection : objections(*load_.pulse))
      objections_.add({"pulse." + objection.key, objection.what, objection.cure});
  }

  std::string path_;
  const LoadTable& load_;
  const CaseTables& tables_;
  const Document& document_;
  InputReport& report_;
  Objections objections_;
};

}  // namespace

void check_loads(const CaseTables& tables, const Document& document, InputReport& report) {
  for (const auto& [name, load] : tables.load_tables)
    if (report.sound(dotted("loads", name) + ".kind")) LoadCheck(name, load, tables, document, report).run();
}

}  // namespace upbead
