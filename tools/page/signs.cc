#include "tools/page/signs.h"

namespace g31::page {
namespace {

constexpr std::string_view kCircle =
    R"(<svg viewBox="0 0 24 24" aria-hidden="true"><circle cx="12" cy="12" r="10.5" fill="none" stroke="currentColor" stroke-width="2"/><path d="M6.8 12.4l3.6 3.6 7-7.6" fill="none" stroke="currentColor" stroke-width="2.2"/></svg>)";
constexpr std::string_view kDiamond =
    R"(<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M12 1.6L22.4 12 12 22.4 1.6 12z" fill="none" stroke="currentColor" stroke-width="2"/><path d="M12 6.8v6.4M12 15.4v2" stroke="currentColor" stroke-width="2.2"/></svg>)";
constexpr std::string_view kOctagon =
    R"html(<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M7.4 1.6h9.2l5.8 5.8v9.2l-5.8 5.8H7.4l-5.8-5.8V7.4z" fill="currentColor"/><path d="M8 8l8 8M16 8l-8 8" stroke="var(--paper)" stroke-width="2.4"/></svg>)html";
constexpr std::string_view kTriangle =
    R"(<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M12 2.2L23 21.5H1z" fill="none" stroke="currentColor" stroke-width="2"/><path d="M12 9v6M12 17v2" stroke="currentColor" stroke-width="2.2"/></svg>)";
constexpr std::string_view kInformation =
    R"(<svg viewBox="0 0 24 24" aria-hidden="true"><circle cx="12" cy="12" r="10" fill="none" stroke="currentColor" stroke-width="2"/><path d="M12 10.5v7M12 6.5v2" stroke="currentColor" stroke-width="2.2"/></svg>)";

}  // namespace

std::string_view svg_of(Sign sign) {
  switch (sign) {
    case Sign::Good:
      return kCircle;
    case Sign::Bad:
      return kDiamond;
    case Sign::Broken:
      break;
  }
  return kOctagon;
}

std::string_view svg_of(source::Severity severity) {
  switch (severity) {
    case source::Severity::Error:
      return kDiamond;
    case source::Severity::Warning:
      return kTriangle;
    case source::Severity::Note:
      break;
  }
  return kInformation;
}

std::string_view class_of(Sign sign) {
  switch (sign) {
    case Sign::Good:
      return "good";
    case Sign::Bad:
      return "bad";
    case Sign::Broken:
      break;
  }
  return "collision";
}

}  // namespace g31::page
