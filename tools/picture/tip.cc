#include "tools/picture/tip.h"

namespace g31::picture {

Point tip_of(const setup::Job& job) {
  if (!job.probe) {
    return Point::Zero();
  }
  const auto& [x, y] = job.probe->eccentricity_mm;
  return {x, y, -job.probe->length_mm};
}

}  // namespace g31::picture
