#include "algo/slam/registration/search_size.h"

#include <cmath>
#include <numbers>

namespace honka {
namespace {

constexpr double kSearchVolume_m3 = 10.0 * 10.0 * 2.0;  // Nevalainen2021 §3

}  // namespace

double search_size_of_ball(double rotation_deg, double translation_m) {
  return std::numbers::pi / 6.0 * std::pow(180.0 / rotation_deg, 3) * kSearchVolume_m3 /
         std::pow(translation_m, 3);
}

double search_size_of_box(double rotation_deg, double translation_m, double zone_deg) {
  return std::pow(180.0 / rotation_deg, 2) * (zone_deg / rotation_deg) * kSearchVolume_m3 /
         std::pow(translation_m, 3);
}

}  // namespace honka
