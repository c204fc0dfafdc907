#include "parts/solids/removal.h"

#include <utility>

#include "parts/import/mesh_file.h"
#include "parts/import/step_file.h"
#include "parts/import/step_library.h"
#include "parts/solids/removal_module.h"

namespace g31::parts {
namespace {

Result<SolidSource, std::string> source_of(const std::string& path) {
  if (is_step_file(path)) {
    return SolidSource{path, path, {}};
  }
  const auto mesh = read_mesh_file(path);
  return mesh ? Result<SolidSource, std::string>(SolidSource{path, "", mesh.value()})
              : Result<SolidSource, std::string>(path + ": " + mesh.error());
}

}  // namespace

Result<Removal, std::string> removal_of(const std::string& product, const StockChoice& stock) {
  static const StepFunction function = find_in_step_library("g31_remove");
  if (function.address == nullptr) {
    return function.why_not;
  }
  const auto product_source = source_of(product);
  if (!product_source) {
    return product_source.error();
  }
  RemovalRequest request;
  request.product = product_source.value();
  request.block_mm = stock.block_mm;
  if (!stock.file.empty()) {
    const auto stock_source = source_of(stock.file);
    if (!stock_source) {
      return stock_source.error();
    }
    request.stock = stock_source.value();
  }
  Removal removal;
  std::string error;
  const auto remove = reinterpret_cast<decltype(&g31_remove)>(function.address);
  if (!remove(&request, &removal, &error)) {
    return error;
  }
  return removal;
}

}  // namespace g31::parts
