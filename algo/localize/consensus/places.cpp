#include "algo/localize/consensus/places.h"

#include <algorithm>
#include <cmath>

#include "algo/localize/consensus/judge.h"

namespace honka {
namespace {

/// Less than `shift_m` apart at the middle of the frame, and turned by less
/// than acos(cosine).
bool are_near(const Placement& a, const Placement& b, double shift_m, double cosine) {
  return (a.shift_m - b.shift_m).squaredNorm() < shift_m * shift_m &&
         a.cosine * b.cosine + a.sine * b.sine > cosine;
}

constexpr double kSameShift_m = 1.0;
constexpr double kSameCosine = 0.99863;  // 3°

}  // namespace

void PlaceList::add(const Fit& fit) {
  if (fit.evidence_nats < Judge::kHopeless_nats) return;
  for (Fit& place : places_) {
    if (!are_near(place.placement, fit.placement, kSameShift_m, kSameCosine)) continue;
    if (fit.evidence_nats > place.evidence_nats) place = fit;
    return;
  }
  places_.push_back(fit);
}

bool PlaceList::knows(const Placement& placement) const {
  constexpr double kReached_m = 0.5;
  return std::any_of(places_.begin(), places_.end(), [&](const Fit& place) {
    return are_near(place.placement, placement, kReached_m, kSameCosine);
  });
}

const Fit* PlaceList::best() const {
  const auto at = std::max_element(places_.begin(), places_.end(), [](const Fit& a, const Fit& b) {
    return a.evidence_nats < b.evidence_nats;
  });
  return at == places_.end() ? nullptr : &*at;
}

std::size_t PlaceList::rivals(double least_nats) const {
  const auto all = std::count_if(places_.begin(), places_.end(), [&](const Fit& place) {
    return place.evidence_nats >= least_nats;
  });
  return all > 0 ? static_cast<std::size_t>(all) - 1 : 0;
}

double PlaceList::margin_nats(double beyond_chance_nats) const {
  constexpr double kLuck = 3.0;  // standard deviations of the pattern's places
  const Fit* first = best();
  double bar = 0.0, sum = 0.0, squares = 0.0, count = 0.0;
  for (const Fit& place : places_) {
    if (are_near(place.placement, first->placement, kSameShift_m, kSameCosine)) continue;
    bar = std::max(bar, place.evidence_nats);
    if (place.evidence_nats < beyond_chance_nats) continue;
    sum += place.evidence_nats;
    squares += place.evidence_nats * place.evidence_nats;
    count += 1.0;
  }
  if (count > 1.0) {
    const double mean = sum / count;
    bar += kLuck * std::sqrt(std::max((squares - sum * mean) / (count - 1.0), 0.0));
  }
  return first->evidence_nats - bar;
}

}  // namespace honka
