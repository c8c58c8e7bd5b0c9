#include "material/asked_law.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <string>
#include <utility>

#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr const char* variable = "UPBEAD_STRESS_LAWS";

[[noreturn]] void refuse(const std::string& why) {
  throw NumericsError("the law of soil in Python: " + why);
}

/// A connection to what answers. Numbers are as this machine has them; a reply is the length of a complaint, and that;
/// where it is 0 the numbers asked for follow.
class Line {
 public:
  Line() : socket_(::socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un to{};
    to.sun_family = AF_UNIX;
    const char* path = std::getenv(variable);
    if (!path || std::string(path).size() >= sizeof to.sun_path) refuse("nobody answers");
    std::string(path).copy(to.sun_path, sizeof to.sun_path - 1);
    if (socket_ < 0 || ::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) {
      if (socket_ >= 0) ::close(socket_);
      refuse("nobody answers");
    }
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line() { ::close(socket_); }

  /// After a complaint nobody answers: a march that tries smaller steps hears it again.
  void send(const void* data, std::size_t size) {
    if (!complaint_.empty()) refuse(complaint_);
    for (const char* from = static_cast<const char*>(data); size > 0;) {
      const ssize_t sent = ::send(socket_, from, size, MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) refuse("it stopped listening");
      from += sent;
      size -= static_cast<std::size_t>(sent);
    }
  }
  void receive(void* data, std::size_t size) {
    for (char* to = static_cast<char*>(data); size > 0;) {
      const ssize_t got = ::recv(socket_, to, size, 0);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) refuse("it stopped answering");
      to += got;
      size -= static_cast<std::size_t>(got);
    }
  }
  void complaint() {
    std::int64_t length = 0;
    receive(&length, sizeof length);
    if (length == 0) return;
    std::string text(static_cast<std::size_t>(length), ' ');
    receive(text.data(), text.size());
    complaint_ = text;
    refuse(text);
  }

 private:
  int socket_;
  std::string complaint_;
};

struct Answer {
  PlaneStress stress;  ///< change since rest (Pa)
  double mobilised = 0.;
};

/// Asks for the points of a region, as many at once as are expected. Several threads may call.
class Asker {
 public:
  explicit Asker(const std::string& region) {
    const auto length = static_cast<std::int64_t>(region.size());
    line_.send(&length, sizeof length);
    line_.send(region.data(), region.size());
    line_.complaint();
  }

  /// A new point at rest; returns its number.
  std::size_t add(const ElasticLaw& elastic, const PlaneStress& rest) {
    const std::lock_guard<std::mutex> lock(mutex_);
    added_.insert(added_.end(), {elastic.G, elastic.lambda, rest.xx, rest.yy, rest.xy, rest.zz});
    points_.push_back({});
    expect(points_.size() - 1, {});
    return points_.size() - 1;
  }
  void expect(std::size_t i, const PlaneStrain& strain) {
    Point& point = points_[i];
    if (!point.open) open_.push_back(i);
    point.open = true;
    point.strain = strain;
  }
  void foresee(std::size_t i, const PlaneStrain& strain) {
    const std::lock_guard<std::mutex> lock(mutex_);
    expect(i, strain);
  }
  Answer answer(std::size_t i, const PlaneStrain& strain) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Point& point = points_[i];
    if (strain.xx != point.strain.xx || strain.yy != point.strain.yy || strain.xy != point.strain.xy) expect(i, strain);
    if (point.open) exchange();
    return point.answer;
  }
  /// The point's history becomes that of its last answer.
  void commit(std::size_t i) {
    const std::lock_guard<std::mutex> lock(mutex_);
    committed_.push_back(static_cast<double>(i));
  }

 private:
  struct Point {
    PlaneStrain strain;
    bool open = false;  ///< not answered yet
    Answer answer;
  };

  void exchange() {
    std::vector<double> asked;
    std::sort(open_.begin(), open_.end());  // threads come in any order
    for (const std::size_t i : open_) {
      const PlaneStrain& e = points_[i].strain;
      asked.insert(asked.end(), {static_cast<double>(i), e.xx, e.yy, e.xy});
    }
    const std::int64_t sizes[] = {static_cast<std::int64_t>(added_.size()),
                                  static_cast<std::int64_t>(committed_.size()),
                                  static_cast<std::int64_t>(asked.size())};
    line_.send(sizes, sizeof sizes);
    for (const auto* part : {&added_, &committed_, &asked}) line_.send(part->data(), part->size() * sizeof(double));
    line_.complaint();
    std::vector<double> found(5 * open_.size());
    line_.receive(found.data(), found.size() * sizeof(double));
    const double* from = found.data();
    for (const std::size_t i : open_) {
      points_[i].answer = {{from[0], from[1], from[2], from[3]}, from[4]};
      points_[i].open = false;
      from += 5;
    }
    added_.clear();
    committed_.clear();
    open_.clear();
  }

  std::mutex mutex_;
  Line line_;
  std::vector<Point> points_;
  std::vector<double> added_, committed_;  ///< since the last exchange
  std::vector<std::size_t> open_;
};

class AskedPoint : public SoilPoint {
 public:
  AskedPoint(std::shared_ptr<Asker> asker, const ElasticLaw& elastic, const PlaneStress& rest)
      : asker_(std::move(asker)), elastic_(elastic), rest_(rest), number_(asker_->add(elastic, rest)) {}

  bool asks() const override { return true; }
  void foresee(const PlaneStrain& strain) const override { asker_->foresee(number_, strain); }
  void correct(const PlaneStrain& strain, PlaneStress& correction) const override {
    correction = difference(elastic_.stress(strain), asker_->answer(number_, strain).stress);
  }
  /// What is dissipated is the work of the stress, by its mean over each step, less what is stored; none as long as
  /// that is round-off, or negative.
  void commit(const PlaneStrain& strain, double& dissipated) override {
    const PlaneStress stress = asker_->answer(number_, strain).stress;
    const PlaneStrain step{strain.xx - strain_.xx, strain.yy - strain_.yy, strain.xy - strain_.xy};
    const double more = 0.5 * work(sum(stress_, stress), step);
    worked_ += more;
    moved_ += std::abs(more);
    const double lost = worked_ - stored(strain, stress), lost_or_none = lost > round_off * moved_ ? lost : 0.;
    dissipated += lost_or_none - lost_;
    lost_ = lost_or_none;
    strain_ = strain;
    stress_ = stress;
    asker_->commit(number_);
  }
  void stored_beside_elastic(const PlaneStrain& strain, double& energy) const override {
    energy = stored(strain, asker_->answer(number_, strain).stress) - 0.5 * work(elastic_.stress(strain), strain);
  }
  double mobilised(int /*lane*/, const PlaneStress& /*change*/) const override {
    return asker_->answer(number_, strain_).mobilised;
  }

 private:
  static double work(const PlaneStress& s, const PlaneStrain& e) {
    return s.xx * e.xx + s.yy * e.yy + 2. * s.xy * e.xy;
  }
  /// s : C s / 2 - rest : (strain - C s), with the elastic compliance C: stored since rest, less the work of the stress
  /// at rest (J/m3).
  double stored(const PlaneStrain& strain, const PlaneStress& s) const {
    const double G2 = 2. * elastic_.G, trace = s.xx + s.yy + s.zz;
    const double share = elastic_.lambda / (G2 + 3. * elastic_.lambda) * trace;
    const PlaneStrain e{(s.xx - share) / G2, (s.yy - share) / G2, s.xy / G2};
    const double e_zz = (s.zz - share) / G2;
    const PlaneStrain left{strain.xx - e.xx, strain.yy - e.yy, strain.xy - e.xy};
    return 0.5 * (work(s, e) + s.zz * e_zz) - (work(rest_, left) - rest_.zz * e_zz);
  }

  std::shared_ptr<Asker> asker_;
  ElasticLaw elastic_;
  PlaneStress rest_;
  std::size_t number_;
  static constexpr double round_off = 1e-12;
  double worked_ = 0., moved_ = 0., lost_ = 0.;  ///< sums since rest: of work, of its size, of losses (J/m3)
  PlaneStrain strain_;                           ///< committed
  PlaneStress stress_;
};

std::function<CellPoints(const CellSoil&)> make(const RegionSoil& soil) {
  return [asker = std::make_shared<Asker>(soil.region)](const CellSoil& cell) -> CellPoints {
    return {[asker, cell](unsigned point) {
              return std::make_unique<AskedPoint>(asker, cell.elastic, cell.at_rest[point % cell.at_rest.size()]);
            },
            false};
  };
}

}  // namespace

bool laws_are_answered() {
  return std::getenv(variable) != nullptr;
}

const SoilLawRow asked_row{"python",
                           "soil by a function of Python",
                           SoilNeeds::function,
                           RestStress::given,
                           "its stress is asked of a function, for tries: law = f in upbead.run, docs/python.md",
                           make,
                           nullptr};

}  // namespace upbead
