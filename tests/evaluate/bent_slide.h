#pragma once

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

// A slide along X with an error, and where the machine truly goes along it.

namespace g31::evaluate::bent_slide {

inline constexpr int kStep = 100;
inline constexpr int kLength = 1000;

/// mm, when X stands at x; 0 at both ends.
inline double error_at(double x) {
  return 0.02 * std::sin(std::numbers::pi * x / kLength) +
         0.003 * std::sin(7.0 * std::numbers::pi * x / kLength);
}

/// What is left of it by lines between the points.
inline double left_at(double x) {
  const double low = std::floor(x / kStep) * kStep;
  const double share = (x - low) / kStep;
  return error_at(x) - (1.0 - share) * error_at(low) - share * error_at(low + kStep);
}

/// The sheet's table is straight over 10 mm: an eighth of 10^2 times the largest curvature, 1.65e-6
/// per mm.
inline constexpr double kTable = 2.1e-5;

/// @param error  EXX, EYX, ...
inline std::string sheet(const char* error) {
  std::string text = fmt::format("[machine.errors]\n{} = [", error);
  for (int x = 0; x <= kLength; x += 10) {
    text += fmt::format("[{}.0, {:.12f}], ", x, error_at(x));
  }
  return text + "]\n";
}

/// How far the tip is beside the encoders in X and Y, by the encoder of X.
struct Beside {
  double x = 0.0;
  double dx = 0.0;
  double dy = 0.0;
};

/// Each sample of a run along X.
inline std::vector<Beside> driven(const testing::TemporaryFolder& folder,
                                  const std::vector<std::string>& programs,
                                  const std::vector<std::string>& sheets) {
  cli::RunOptions run;
  run.programs = programs;
  run.setups = sheets;
  run.trace = folder.path("trace.csv");
  const auto output = testing::run_program(run);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::ifstream in(run.trace);
  std::string line;
  std::getline(in, line);
  EXPECT_TRUE(
      line.starts_with("time_s,X_commanded,Y_commanded,Z_commanded,X_encoder,Y_encoder,"
                       "Z_encoder,X_true,Y_true"));
  std::vector<Beside> way;
  while (std::getline(in, line)) {
    std::vector<double> values;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      values.push_back(std::stod(field));
    }
    EXPECT_EQ(values.at(5), 0.0);  // the encoder of Y knows of nothing
    way.push_back({values.at(4), values.at(7) - values.at(4), values.at(8) - values.at(5)});
  }
  EXPECT_GT(way.size(), 100U);
  return way;
}

}  // namespace g31::evaluate::bent_slide
