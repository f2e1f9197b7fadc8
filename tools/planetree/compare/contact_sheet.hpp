#pragma once

#include "render/image.hpp"
#include "render/render_image.hpp"

#include <optional>
#include <string>
#include <vector>

namespace planetree::tool {

/// One row of a contact sheet.
struct SheetRow {
  std::string title;    ///< large
  std::string figures;  ///< small, beside it, or below where it is too long
  render::Rendering picture;
  render::Rendering heat;
};

/// A contact sheet and what its colours stand for.
struct ContactSheet {
  render::Image image;
  render::ValueRange range;
};

/// Pictures row by row, beside each the heat, in colours that mean the same in all rows; the legend
/// of these stands at the bottom. The brightest colour stands for `heatMax` steps, or, unless that
/// is given, for the most that any row would choose by itself. There must be a row, and all
/// pictures have one size.
[[nodiscard]] ContactSheet contactSheet(const std::string& title, const std::vector<SheetRow>& rows,
                                        std::optional<double> heatMax);

}  // namespace planetree::tool
