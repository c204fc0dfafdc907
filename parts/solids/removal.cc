#include "parts/solids/removal.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "parts/features/faceted_walls.h"
#include "parts/import/made_apart.h"
#include "parts/import/mesh_file.h"
#include "parts/import/step_file.h"
#include "parts/import/step_library.h"
#include "parts/solids/removal_bytes.h"
#include "parts/solids/removal_module.h"

namespace g31::parts {
namespace {

Result<SolidSource, std::string> source_of(const std::string& path, const GoesOn& goes_on) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) {
    return path + ": there is no such file";
  }
  if (std::filesystem::is_directory(path, unknown)) {
    return path + ": this is a folder; name a STEP file or a mesh in it";
  }
  if (!std::filesystem::is_regular_file(path, unknown)) {
    return fmt::format("{}: {}", path, kNoRegularFile);
  }
  if (is_step_file(path)) {
    return SolidSource{path, path, {}};
  }
  const auto mesh = read_mesh_file(path, {.goes_on = goes_on});
  return mesh ? Result<SolidSource, std::string>(SolidSource{path, "", mesh.value()})
              : Result<SolidSource, std::string>(path + ": " + mesh.error());
}

/// What the module makes of a request, in a process of its own.
Result<Removal, std::string> remove_apart(decltype(&g31_remove) remove,
                                          const RemovalRequest& request, const GoesOn& goes_on) {
  MadeApart<Removal> apart = make_apart<Removal>(
      [&](Removal& removal) {
        std::string error;
        remove(&request, &removal, &error);
        return error;
      },
      goes_on);
  if (!apart.why_not.empty()) {
    return fmt::format("{}: Open CASCADE does not get through it ({})", request.product.name,
                       apart.why_not);
  }
  return apart.error.empty() ? Result<Removal, std::string>(std::move(apart.made)) : apart.error;
}

}  // namespace

Result<Removal, std::string> removal_of(const std::string& product, const StockChoice& stock,
                                        const GoesOn& goes_on) {
  static const ModuleFunction function = find_in_step_library("g31_remove");
  if (function.address == nullptr) {
    return function.why_not;
  }
  const auto product_source = source_of(product, goes_on);
  if (!product_source) {
    return product_source.error();
  }
  RemovalRequest request;
  request.product = product_source.value();
  request.block_mm = stock.block_mm;
  if (!stock.file.empty()) {
    const auto stock_source = source_of(stock.file, goes_on);
    if (!stock_source) {
      return stock_source.error();
    }
    request.stock = stock_source.value();
  }
  auto removal =
      remove_apart(reinterpret_cast<decltype(&g31_remove)>(function.address), request, goes_on);
  if (!removal || !request.product.step_path.empty()) {
    return removal;
  }
  Removal of_mesh = removal.value();
  std::ranges::for_each(of_mesh.volumes, find_round_walls);
  const double of_stock = request.stock ? request.stock->mesh.rounding_mm : 0.0;
  for (RemovedVolume& volume : of_mesh.volumes) {
    volume.rounding_mm = std::max(request.product.mesh.rounding_mm, of_stock);
  }
  return of_mesh;
}

}  // namespace g31::parts
