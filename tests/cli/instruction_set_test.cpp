#include "tool_run.hpp"

#include <planetree/traversal/instruction_set.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

using nlohmann::json;

/// The tool with a model and the variable PLANETREE_ISA.
class InstructionSet : public ToolTest {
 protected:
  InstructionSet() { writeModel("model.obj"); }

  [[nodiscard]] ToolResult runWith(const std::string& instructionSet,
                                   std::vector<std::string> arguments) const {
    return run(ToolStart{.arguments = std::move(arguments),
                         .environment = {"PLANETREE_ISA=" + instructionSet}});
  }
};

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST_F(InstructionSet, InfoNamesTheOneInUseAndWhatTheMachineHas) {
  for (const std::string_view name : supportedInstructionSets()) {
    const ToolResult page = runWith(std::string(name), {"info", "model.obj"});
    EXPECT_EQ(page.status, 0) << page.err;
    EXPECT_TRUE(contains(page.out, "instruction set" + std::string(13 - name.size(), ' ') + "  " +
                                       std::string(name)))
        << page.out;
    const json document =
        json::parse(runWith(std::string(name), {"info", "model.obj", "--json"}).out);
    EXPECT_EQ(document["instruction_set"], name);
    EXPECT_EQ(document["supported_instruction_sets"].size(), supportedInstructionSets().size());
    EXPECT_EQ(document["supported_instruction_sets"].back(), "scalar");
  }
}

TEST_F(InstructionSet, IsTheBestOneIfNothingOrNothingInParticularIsAskedFor) {
  const auto used = [](const ToolResult& result) {
    return json::parse(result.out)["instruction_set"].get<std::string>();
  };
  const std::string_view best = supportedInstructionSets().front();
  EXPECT_EQ(used(runWith("", {"info", "model.obj", "--json"})), best);
}

TEST_F(InstructionSet, RefusesANameThatTheMachineHasNothingFor) {
  const std::span<const std::string_view> supported = supportedInstructionSets();
  const bool isX86 = std::find(supported.begin(), supported.end(), "sse4") != supported.end();
  for (const std::string& name : {std::string("mmx"), std::string("AVX2"), std::string("avx2 "),
                                  std::string(isX86 ? "neon" : "sse4")}) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"info", "model.obj"}, {"render", "-o", "picture.png"}}) {
      const ToolResult result = runWith(name, arguments);
      EXPECT_EQ(result.status, 2) << name;
      EXPECT_EQ(result.out, "");
      EXPECT_TRUE(contains(result.err, "planetree: PLANETREE_ISA=" + name + ": ")) << result.err;
      for (const std::string_view known : supported)
        EXPECT_TRUE(contains(result.err, known)) << result.err;
    }
  }
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"model.obj"});
}

TEST_F(InstructionSet, HelpAndVersionAreThereWhateverIsAskedFor) {
  EXPECT_EQ(runWith("mmx", {"--help"}).status, 0);
  EXPECT_EQ(runWith("mmx", {"--version"}).status, 0);
}

TEST_F(InstructionSet, PicturesAreTheSameOnAll) {
  std::vector<std::string> pictures;
  for (const std::string_view name : supportedInstructionSets()) {
    ASSERT_EQ(runWith(std::string(name), {"render", "model.obj", "--samples", "1", "--size",
                                          "48x32", "-o", "picture.png"})
                  .status,
              0);
    pictures.push_back(readFile("picture.png"));
    EXPECT_TRUE(pictures.back() == pictures.front()) << name;
  }
}

}  // namespace
}  // namespace planetree::test
