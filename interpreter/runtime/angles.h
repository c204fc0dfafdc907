#pragma once

namespace g31::runtime {

/// Trigonometry in decimal degrees, as programs write it.  Multiples of 90 (and the halves at 30
/// and 60) come out exactly, whatever the full turns; otherwise within 2 ulp of the true value.
double sine_deg(double degrees);
double cosine_deg(double degrees);

}  // namespace g31::runtime
