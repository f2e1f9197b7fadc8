#include "compare/contact_sheet.hpp"

#include "render/overlay/heat_legend.hpp"
#include "render/overlay/stroke_font.hpp"
#include "render/shading/heat.hpp"

#include <algorithm>
#include <cmath>

namespace planetree::tool {

namespace {

using render::Image;
using render::ImageSize;
using render::Rgb8;

// Those of the legend.
constexpr Rgb8 kPaper{255, 255, 255};
constexpr Rgb8 kInk{38, 38, 38};
constexpr Rgb8 kFaintInk{90, 90, 90};

// In units of text.
constexpr double kMargin = 8.0;
constexpr double kTitleScale = 1.4;

/// What the colours of all rows stand for together.
render::ValueRange commonRange(const std::vector<SheetRow>& rows, std::optional<double> heatMax) {
  render::ValueRange common = *rows.front().heat.range;
  common.mean = 0.0;
  for (const SheetRow& row : rows) {
    const render::ValueRange& range = *row.heat.range;
    common.brightest = std::max(common.brightest, range.brightest);
    common.lowest = std::min(common.lowest, range.lowest);
    common.highest = std::max(common.highest, range.highest);
    common.mean += range.mean / static_cast<double>(rows.size());
  }
  common.brightest = heatMax.value_or(common.brightest);
  return common;
}

/// The picture of `heat` as if it had been asked for with that brightest colour.
Image heatImage(const render::Rendering& heat, double brightest) {
  render::Rendering recoloured = heat;
  recoloured.development = render::Heat(brightest).develop(heat.film);
  return shownImage(recoloured);
}

void copy(const Image& from, Image& to, std::uint32_t left, std::uint32_t top) {
  for (std::uint32_t y = 0; y < from.size.height; ++y) {
    for (std::uint32_t x = 0; x < from.size.width; ++x)
      to.at(left + x, top + y) = from.at(x, y);
  }
}

/// Where things are, in pixels.
struct Layout {
  ImageSize picture;
  render::TextSize text;
  render::TextSize titleText;
  std::uint32_t margin = 0;
  std::uint32_t width = 0;
  std::uint32_t labelHeight = 0;
  bool hasLongFigures = false;  ///< they stand below the titles of their rows

  [[nodiscard]] std::uint32_t rowHeight() const noexcept { return labelHeight + picture.height; }
};

Layout makeLayout(const std::vector<SheetRow>& rows) {
  Layout layout;
  layout.picture = rows.front().picture.film.size();
  constexpr double kPixelsPerUnit = 300.0;
  constexpr double kSmallest = 1.0;
  layout.text.unit =
      std::max(kSmallest, std::round(5.0 * layout.picture.width / kPixelsPerUnit) / 5.0);
  layout.titleText.unit = kTitleScale * layout.text.unit;
  layout.margin = static_cast<std::uint32_t>(std::lround(kMargin * layout.text.unit));
  layout.width = 2 * layout.picture.width + 3 * layout.margin;
  for (const SheetRow& row : rows) {
    const double needed = textWidth(row.title, layout.titleText) +
                          textWidth(row.figures, layout.text) + 4.0 * layout.margin;
    layout.hasLongFigures = layout.hasLongFigures || needed > layout.width;
    const double figures = textWidth(row.figures, layout.text) + 2.0 * layout.margin;
    layout.width = std::max(layout.width, static_cast<std::uint32_t>(std::ceil(figures)));
  }
  const double lineHeight = 2.0 * render::kDigitHeight * layout.text.unit;
  layout.labelHeight = static_cast<std::uint32_t>(
      std::lround(layout.margin + (layout.hasLongFigures ? 2.2 : 1.2) * lineHeight));
  return layout;
}

void drawLabel(Image& sheet, const Layout& layout, const SheetRow& row, std::uint32_t top) {
  const double left = layout.margin;
  const double lineHeight = 2.0 * render::kDigitHeight * layout.text.unit;
  const double firstLine = top + layout.margin + render::kDigitHeight * layout.titleText.unit;
  drawText(sheet, {left, firstLine}, layout.titleText, row.title, kInk);
  const double right = layout.width - layout.margin - textWidth(row.figures, layout.text);
  const render::Point2 place = layout.hasLongFigures ? render::Point2{left, firstLine + lineHeight}
                                                     : render::Point2{right, firstLine};
  drawText(sheet, place, layout.text, row.figures, kFaintInk);
}

}  // namespace

ContactSheet contactSheet(const std::string& title, const std::vector<SheetRow>& rows,
                          std::optional<double> heatMax) {
  const render::ValueRange range = commonRange(rows, heatMax);
  const Layout layout = makeLayout(rows);
  const auto headHeight = static_cast<std::uint32_t>(
      std::lround(1.5 * layout.margin + render::kDigitHeight * layout.titleText.unit));
  const auto rowCount = static_cast<std::uint32_t>(rows.size());
  Image sheet({layout.width, headHeight + rowCount * layout.rowHeight() + layout.margin});
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), kPaper);
  drawText(sheet, {static_cast<double>(layout.margin), headHeight - layout.margin / 2.0},
           layout.titleText, title, kInk);
  std::uint32_t top = headHeight;
  for (const SheetRow& row : rows) {
    drawLabel(sheet, layout, row, top);
    copy(shownImage(row.picture), sheet, layout.margin, top + layout.labelHeight);
    copy(heatImage(row.heat, range.brightest), sheet, 2 * layout.margin + layout.picture.width,
         top + layout.labelHeight);
    top += layout.rowHeight();
  }
  return {withHeatLegend(sheet, range), range};
}

}  // namespace planetree::tool
