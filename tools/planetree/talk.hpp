#pragma once

#include "import/import_mesh.hpp"
#include "render/render_image.hpp"

#include <planetree/node/tree_statistics.hpp>
#include <planetree/split/build_report.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// What the tool says beside its result. All of it goes to standard error: standard output belongs
/// to data.
namespace planetree::tool {

/// Prints without adding a line end. A standard error that is closed or full is no reason to fail.
void printToStandardError(std::string_view text) noexcept;

class Talk {
 public:
  explicit Talk(bool isQuiet) noexcept : Talk(isQuiet, !isQuiet) {}
  /// For what is said elsewhere: no lines, but it may show how far it is.
  [[nodiscard]] static Talk ofProgress(bool isShown) noexcept { return {true, isShown}; }

  [[nodiscard]] bool showsProgress() const noexcept { return showsProgress_; }

  /// One line, unless the tool is to be quiet.
  void say(std::string_view line) const {
    if (!isQuiet_)
      printToStandardError(std::string(line) + "\n");
  }

 private:
  Talk(bool isQuiet, bool showsProgress) noexcept
      : isQuiet_(isQuiet), showsProgress_(showsProgress) {}

  bool isQuiet_;
  bool showsProgress_;
};

/// "69666" as "69,666".
[[nodiscard]] std::string grouped(std::uint64_t number);
/// "69,666 triangles", "1 triangle"; the plural is given where it is not the word with an s.
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view word,
                                  std::string_view plural = {});
/// "1.4 MB".
[[nodiscard]] std::string byteText(std::uint64_t bytes);
/// What is wrong with a skipped object, to be read after its name.
[[nodiscard]] std::string_view reasonText(SkipReason reason) noexcept;
/// What is wrong with the size of a scene, to be read after "the scene"; empty if nothing is.
[[nodiscard]] std::string rangeText(SceneRange range);

struct MeshSize {
  std::uint64_t faceCount = 0;
  std::uint64_t vertexCount = 0;
};

void sayMesh(const Talk& talk, const std::string& name, const MeshSize& size,
             const importing::ImportReport& report, double seconds);

/// That hits may be lost, if the size of the scene is beyond the limits.
void sayRange(const Talk& talk, const BuildReport& report);

/// The skipped faces of a mesh. `sourceFaces` is that of the mesh: faces are named by their number
/// in the file.
void saySkipped(const Talk& talk, const BuildReport& report,
                std::span<const std::uint32_t> sourceFaces);

void sayTree(const Talk& talk, const BuildReport& report, const TreeStatistics& statistics,
             std::string_view object);

void sayRendering(const Talk& talk, render::RenderMode mode, const render::Rendering& rendering);

}  // namespace planetree::tool
