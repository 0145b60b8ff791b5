#include "algo/odometry/stems/search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algo/odometry/stems/motion.h"
#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr double kVoteCell_m = 0.5;
constexpr double kYawStep_deg = 2.0;  // 0.7 m at 20 m: within two cells
constexpr std::size_t kMostVoters = 40;

/// The nearest sightings: their places suffer least from a wrong yaw.
std::vector<Eigen::Vector3d> voters_of(std::span<const PlacedSighting> sightings) {
  std::vector<Eigen::Vector3d> voters;
  for (const PlacedSighting& s : sightings) voters.push_back(s.centre_m);
  std::stable_sort(voters.begin(), voters.end(),
                   [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  if (voters.size() > kMostVoters) voters.resize(kMostVoters);
  return voters;
}

struct BestShift {
  int votes = 0;
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
};

class ShiftVotes {
 public:
  explicit ShiftVotes(double search_m)
      : half_(static_cast<int>(std::ceil(search_m / kVoteCell_m))), side_(2 * half_ + 2) {}

  BestShift poll(const std::vector<Eigen::Vector3d>& centres_m, const StemLandmarkMap& stems) {
    votes_.assign(static_cast<std::size_t>(side_ * side_), 0);
    for (const Eigen::Vector3d& c : centres_m) {
      for (const std::uint32_t i : stems.near()) {
        const Eigen::Vector2d off = (stems[i].at(c.z()) - c.head<2>()) / kVoteCell_m;
        const int x = static_cast<int>(std::floor(off.x())) + half_;
        const int y = static_cast<int>(std::floor(off.y())) + half_;
        if (x >= 0 && y >= 0 && x < side_ && y < side_) ++votes_[at(x, y)];
      }
    }
    BestShift best;
    for (int y = 0; y + 1 < side_; ++y) {
      for (int x = 0; x + 1 < side_; ++x) {
        const int sum = votes_[at(x, y)] + votes_[at(x + 1, y)] + votes_[at(x, y + 1)] +
                        votes_[at(x + 1, y + 1)];
        if (sum > best.votes) {
          best = {sum, kVoteCell_m * Eigen::Vector2d(x + 1 - half_, y + 1 - half_)};
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y * side_ + x);
  }
  int half_, side_;
  std::vector<int> votes_;
};

}  // namespace

std::optional<Pose3> search_place(std::span<const PlacedSighting> sightings,
                                  const StemLandmarkMap& stems, const Pose3& T_odom_predicted,
                                  const StemRegistrationSettings& settings) {
  const std::vector<Eigen::Vector3d> voters = voters_of(sightings);
  ShiftVotes votes(settings.search_m);
  BestShift best;
  Pose3 T_odom_best = T_odom_predicted;
  std::vector<Eigen::Vector3d> centres_m(voters.size());
  const int steps = static_cast<int>(settings.search_deg / kYawStep_deg);
  for (int k = 0; k <= 2 * steps; ++k) {
    // 0, 1, −1, 2, −2 …: of equals the least turn wins.
    const double yaw = deg_to_rad(kYawStep_deg) * (k % 2 == 1 ? (k + 1) / 2 : -k / 2);
    Twist turn = Twist::Zero();
    turn(5) = yaw;
    const Pose3 T_odom_turned = moved(T_odom_predicted, turn);
    for (std::size_t i = 0; i < voters.size(); ++i) centres_m[i] = T_odom_turned * voters[i];
    const BestShift shift = votes.poll(centres_m, stems);
    if (shift.votes <= best.votes) continue;
    best = shift;
    T_odom_best = T_odom_turned;
    T_odom_best.translation().head<2>() += shift.shift_m;
  }
  if (best.votes < std::max<int>(static_cast<int>(settings.min_stems), 4)) return std::nullopt;
  return T_odom_best;
}

}  // namespace honka
