#include "sim/forest/spacing/domain.h"

#include <cmath>

#include "algo/types/user_error.h"

namespace honka::sim {

Eigen::Vector2d SpacingDomain::draw(RandomStream& stream) const {
  constexpr int kTries = 100000;
  for (int i = 0; i < kTries; ++i) {
    const double x = stream.uniform(box_m.min().x(), box_m.max().x());
    const double y = stream.uniform(box_m.min().y(), box_m.max().y());
    if (is_free({x, y})) return {x, y};
  }
  throw UserError("forest: corridors leave no ground for trees; make them narrower or fewer");
}

Eigen::Vector2d SpacingDomain::wrapped(const Eigen::Vector2d& position_m) const {
  const Eigen::Vector2d sizes = box_m.sizes();
  Eigen::Vector2d offset = position_m - box_m.min();
  offset.x() -= sizes.x() * std::floor(offset.x() / sizes.x());
  offset.y() -= sizes.y() * std::floor(offset.y() / sizes.y());
  return box_m.min() + offset;
}

double free_area_m2(const SpacingDomain& domain, double step_m) {
  const Eigen::Vector2d sizes = domain.box_m.sizes();
  const int nx = static_cast<int>(std::ceil(sizes.x() / step_m));
  const int ny = static_cast<int>(std::ceil(sizes.y() / step_m));
  const Eigen::Vector2d step(sizes.x() / nx, sizes.y() / ny);
  std::int64_t free = 0;
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      const Eigen::Vector2d middle(x + 0.5, y + 0.5);
      if (domain.is_free(domain.box_m.min() + step.cwiseProduct(middle))) ++free;
    }
  }
  return static_cast<double>(free) * step.x() * step.y();
}

}  // namespace honka::sim
