#include "algo/slam/registration/registration.h"

namespace honka {

std::string_view registration_status_name(RegistrationStatus status) {
  switch (status) {
    case RegistrationStatus::kRegistered:
      return "registered";
    case RegistrationStatus::kTooFewPoints:
      return "too_few_points";
    case RegistrationStatus::kNotFinite:
      return "not_finite";
    case RegistrationStatus::kUnverified:
      return "unverified";
    case RegistrationStatus::kTimeCap:
      return "time_cap";
  }
  return "unknown";
}

}  // namespace honka
