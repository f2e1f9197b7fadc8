#pragma once

#include "talk.hpp"

#include "import/import_mesh.hpp"

#include <planetree/node/tree_statistics.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/build_report.hpp>

#include <nlohmann/json_fwd.hpp>
#include <string>

/// What subcommands say under `--json`: the same things under the same keys. docs/command_line.md
/// lists them. To put documents together, include <nlohmann/json.hpp>.
namespace planetree::tool {

/// Members stay in the order in which they were added.
using Json = nlohmann::ordered_json;

/// A model as it was read, for the key "mesh".
[[nodiscard]] Json meshJson(const MeshSize& size, const importing::ImportReport& report);

/// How a tree was built, for the key "build".
[[nodiscard]] Json buildJson(const BuildOptions& options, const BuildReport& report);

/// A tree in numbers, for the key "tree".
[[nodiscard]] Json treeJson(const TreeStatistics& statistics);

/// The document as text, with a line end. Numbers that are not finite become null, and what is no
/// UTF-8 in file names is replaced.
[[nodiscard]] std::string jsonText(const Json& json);

/// Prints the document on standard output; on standard error if that carries the data.
void printJson(const Json& json, bool isDataOnStandardOutput);

}  // namespace planetree::tool
