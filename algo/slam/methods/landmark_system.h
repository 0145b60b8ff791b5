#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "algo/geometry/se3.h"
#include "algo/slam/methods/stem_map.h"
#include "algo/slam/sparse_frame.h"

namespace honka {

/// Inverse standard deviations of the adjustment, and where its losses bend.
struct LandmarkWeights {
  double per_planar_m = 0.0, per_vertical_m = 0.0;  ///< of an observation
  double robust_scale = 0.0;                        ///< Cauchy; 0: none
  double per_chain_m = 0.0, per_chain_rad = 0.0;    ///< of a tie between neighbours
};

/// A measured step of the chain that ties frame `from` to the next.
struct ChainTie {
  std::size_t from = 0;
  Pose3 T_from_next = Pose3::Identity();
};

/// The least-squares problem of poses and stems about one linearization. A pose moves by (δt, δω):
/// t + δt, exp(δω) R, both in the axes of the first frame; a stem by δm. Stems are eliminated
/// (their blocks are diagonal) and the poses' system is solved by conjugate gradients, without ever
/// being written down: it costs two passes over the observations a step, so that the whole
/// adjustment is faster than any factorization of so dense a graph.
class LandmarkSystem {
 public:
  /// All must outlive the system.
  LandmarkSystem(std::span<const SparseFrame> frames, const StemMap3& map,
                 std::span<const ChainTie> chain, const LandmarkWeights& weights);

  /// Half the robust sum of squares at some poses and stems.
  [[nodiscard]] double cost(const FramePoses& poses,
                            std::span<const Eigen::Vector3d> stems_m) const;

  /// Linearizes about poses and stems; then `solve` gives the step of each pose and of each stem.
  void linearize(const FramePoses& poses, std::span<const Eigen::Vector3d> stems_m);
  /// Derivative of the cost by the poses' motions, at the linearization.
  [[nodiscard]] const std::vector<Twist>& pose_gradient() const { return gradient_; }
  struct Step {
    std::vector<Twist> poses;
    std::vector<Eigen::Vector3d> stems_m;
    int iterations = 0;
  };
  /// Conjugate gradients until the residual has fallen by `tolerance`.
  [[nodiscard]] Step solve(double tolerance, int max_iterations) const;

 private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  /// An observation as linearized. Small, as the solution passes over all of them again and again.
  struct Seen {
    Eigen::Vector3d arm_m;  ///< from the lidar to the point, in the first frame's axes
    double weight;          ///< of the robust loss
    std::uint32_t stem;
  };
  struct Tie {
    std::size_t from;
    Eigen::Vector3d arm_m;  ///< R_l times the step's translation
    Eigen::Vector3d residual_m, residual_rad;
  };

  void linearize_observations(const FramePoses& poses, std::span<const Eigen::Vector3d> stems_m);
  void linearize_ties(const FramePoses& poses);
  void invert_blocks();
  /// Adds what the ties pull at each pose when the poses move by x.
  void add_ties(const std::vector<Twist>& x, std::vector<Twist>& out) const;
  /// S x: what pulls at each pose when the poses move by x and the stems have followed.
  void multiply(const std::vector<Twist>& x, std::vector<Twist>& out) const;
  [[nodiscard]] std::vector<Twist> reduced_gradient() const;
  /// The weighted mean, at each stem, of what its observations move by.
  [[nodiscard]] std::vector<Eigen::Vector3d> mean_moves(const std::vector<Twist>& x) const;
  [[nodiscard]] std::span<const Seen> seen_by(std::size_t frame) const {
    return std::span(seen_).subspan(first_seen_[frame],
                                    first_seen_[frame + 1] - first_seen_[frame]);
  }

  std::span<const SparseFrame> frames_;
  const StemMap3& map_;
  std::span<const ChainTie> chain_;
  LandmarkWeights weights_;
  Eigen::Vector3d metric_;  ///< D: inverse variances of an observation along x, y, z

  std::vector<Seen> seen_;               ///< by frame
  std::vector<std::size_t> first_seen_;  ///< of each frame, and the end
  std::vector<Tie> ties_;
  std::vector<double> per_weight_;                ///< of each stem: 1 / Σ w
  std::vector<Eigen::Vector3d> mean_residual_m_;  ///< of each stem: Σ w r / Σ w
  std::vector<Twist> gradient_;                   ///< of the poses, with the stems held still
  std::vector<Matrix6> preconditioner_;           ///< inverses of the poses' own blocks
};

/// t + δt, exp(δω) R.
[[nodiscard]] Pose3 stepped(const Pose3& pose, const Twist& step);

}  // namespace honka
