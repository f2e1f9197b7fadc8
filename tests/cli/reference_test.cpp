#include "command_line.hpp"

#include "option_syntax.hpp"
#include "support/nearest_name.hpp"
#include "tool_run.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

/// Help, completions and the manual, which are made from the definitions of the options.
namespace planetree::test {
namespace {

using tool::CommandSyntax;
using tool::OptionSyntax;

class Reference : public ToolTest {
 protected:
  static bool isInstalled(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
  }

  /// What a shell prints that runs the script in the folder.
  [[nodiscard]] std::string shell(const std::string& program, const std::string& script) const {
    std::ofstream(streamFolder() / "script") << script;
    const std::string command = "cd '" + folder().string() + "' && " + program + " '" +
                                (streamFolder() / "script").string() + "' 2>&1";
    std::string printed;
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    std::array<char, 4096> some{};
    while (const std::size_t count = std::fread(some.data(), 1, some.size(), pipe))
      printed.append(some.data(), count);
    ::pclose(pipe);
    return printed;
  }

  /// Writes what the tool prints to a file outside of the folder, and returns its name.
  [[nodiscard]] std::string saved(const std::vector<std::string>& arguments) const {
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::string name = (streamFolder() / "saved").string();
    std::ofstream(name) << result.out;
    return name;
  }

  /// What bash offers for the last of the words of a command line.
  [[nodiscard]] std::vector<std::string> bashOffers(const std::vector<std::string>& words) const {
    std::string script = "source '" + saved({"completion", "bash"}) + "'\nCOMP_WORDS=(";
    for (const std::string& word : words)
      script += " '" + word + "'";
    script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
              "\n_planetree\nprintf '%s\\n' \"${COMPREPLY[@]}\" | sort\n";
    std::istringstream printed(shell("bash", script));
    std::vector<std::string> offers;
    for (std::string line; std::getline(printed, line);) {
      if (!line.empty())
        offers.push_back(line);
    }
    return offers;
  }
};

using Offers = std::vector<std::string>;

TEST_F(Reference, BashCompletesCommandsAndOptions) {
  EXPECT_EQ(bashOffers({"planetree", "re"}), Offers{"render"});
  EXPECT_EQ(bashOffers({"planetree", "--v"}), Offers{"--version"});
  EXPECT_EQ(bashOffers({"planetree", "trace", "--t"}),
            (Offers{"--t-max", "--t-min", "--threads", "--traversal-cost"}));
  EXPECT_EQ(bashOffers({"planetree", "help", "ex"}), Offers{"explain"});
  EXPECT_EQ(bashOffers({"planetree", "completion", ""}), (Offers{"bash", "fish", "zsh"}));
}

TEST_F(Reference, BashCompletesTheWordsThatAnOptionTakes) {
  EXPECT_EQ(bashOffers({"planetree", "trace", "--preset", ""}),
            (Offers{"balanced", "fast", "high", "textbook"}));
  EXPECT_EQ(bashOffers({"planetree", "trace", "--preset", "=", "te"}), Offers{"textbook"});
  EXPECT_EQ(bashOffers({"planetree", "trace", "--preset", "="}),
            (Offers{"balanced", "fast", "high", "textbook"}));
  EXPECT_EQ(bashOffers({"planetree", "trace", "--leaf-size", ""}), Offers{});
}

TEST_F(Reference, BashCompletesModelsAndFiles) {
  writeModel("my model.obj");
  writeModel("UPPER.STL");
  writeFile("rays.csv", "");
  std::filesystem::create_directory(folder() / "models");
  EXPECT_EQ(bashOffers({"planetree", "info", ""}), (Offers{"UPPER.STL", "models", "my model.obj"}));
  EXPECT_EQ(bashOffers({"planetree", "trace", "my model.obj", "r"}), Offers{"rays.csv"});
  EXPECT_EQ(bashOffers({"planetree", "trace", "-o", "ra"}), Offers{"rays.csv"});
}

TEST_F(Reference, FishCompletes) {
  if (!isInstalled("fish"))
    GTEST_SKIP() << "fish is not installed";
  writeModel("roof.obj");
  writeFile("rays.csv", "");
  const std::string source = "source '" + saved({"completion", "fish"}) + "'\ncomplete -C ";
  EXPECT_EQ(shell("fish", source + "'planetree trace --pres'").find("--preset"), 0u);
  EXPECT_EQ(shell("fish", source + "'planetree trace --preset te'").find("textbook"), 0u);
  EXPECT_EQ(shell("fish", source + "'planetree rend'").find("render"), 0u);
  EXPECT_EQ(shell("fish", source + "'planetree info ro'").find("roof.obj"), 0u);
  EXPECT_EQ(shell("fish", source + "'planetree info ra'"), "");
}

TEST_F(Reference, ZshTakesTheScript) {
  if (!isInstalled("zsh"))
    GTEST_SKIP() << "zsh is not installed";
  const std::string script = saved({"completion", "zsh"});
  EXPECT_EQ(shell("zsh -f", "zsh -n '" + script + "'\nautoload -U compinit && compinit -D\n" +
                                "source '" + script + "'\nprint $_comps[planetree]\n"),
            "_planetree\n");
}

TEST_F(Reference, TheManualHasNothingToComplainOf) {
  const std::string page = saved({"man"});
  if (isInstalled("mandoc")) {
    EXPECT_EQ(shell("sh", "mandoc -Tlint -W warning '" + page + "'"), "");
  }
  if (isInstalled("groff")) {
    EXPECT_EQ(shell("sh", "groff -man -ww -Tutf8 -z '" + page + "'"), "");
  }
  if (!isInstalled("mandoc") && !isInstalled("groff"))
    GTEST_SKIP() << "neither mandoc nor groff is installed";
}

/// How a name of an option stands in a script or page.
std::string withoutDashes(const std::string& name) {
  return name.substr(name.find_first_not_of('-'));
}

TEST_F(Reference, EveryOptionOfEveryCommandIsInAllOfThem) {
  const std::string bash = run({"completion", "bash"}).out;
  const std::string zsh = run({"completion", "zsh"}).out;
  const std::string fish = run({"completion", "fish"}).out;
  std::string man = run({"man"}).out;
  for (std::size_t at = man.find("\\-"); at != std::string::npos; at = man.find("\\-", at))
    man.replace(at, 2, "-");

  for (const CommandSyntax& command : tool::commandSyntax(tool::CommandLine().app()).commands) {
    const std::string help = run({"help", command.name}).out;
    EXPECT_EQ(help, run({command.name, "--help"}).out);
    EXPECT_NE(bash.find("\n    " + command.name + ")"), std::string::npos) << command.name;
    EXPECT_NE(zsh.find("\n    " + command.name + ")"), std::string::npos) << command.name;
    EXPECT_NE(man.find(".SS planetree " + command.name + "\n"), std::string::npos) << command.name;
    for (const OptionSyntax& option : command.options) {
      const std::string& name = option.names.back();
      EXPECT_NE(help.find(name), std::string::npos) << command.name << " " << name;
      EXPECT_NE(man.find(name), std::string::npos) << command.name << " " << name;
      if (option.isPositional)
        continue;
      EXPECT_NE(bash.find(name), std::string::npos) << command.name << " " << name;
      EXPECT_NE(zsh.find(name), std::string::npos) << command.name << " " << name;
      EXPECT_NE(fish.find("__fish_seen_subcommand_from " + command.name), std::string::npos);
      EXPECT_NE(fish.find(" -l " + withoutDashes(name)), std::string::npos) << name;
    }
  }
}

/// What a file of the repository says.
std::string textOf(const std::string& name) {
  std::ifstream file(std::string(PLANETREE_REPOSITORY) + "/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(Reference, EveryKeyOfTheJsonIsInTheDocs) {
  writeModel("roof.obj");
  writeFile("rays.csv", "0.1,0.1,5,0,0,-1\n");
  const ToolResult result = run({"trace", "roof.obj", "rays.csv", "-o", "hits.csv", "--json"});
  const std::string docs = textOf("docs/command_line.md");
  const auto expectNamed = [&](const std::string& key) {
    EXPECT_NE(docs.find("`" + key + "`"), std::string::npos) << key;
  };
  const auto json = nlohmann::json::parse(result.out);
  for (const auto& [key, value] : json.items()) {
    expectNamed(key);
    if (!value.is_object())
      continue;
    for (const auto& part : value.items())
      expectNamed(std::string(key).append(".").append(part.key()));
  }
  for (const auto& option : json["build"]["options"].items())
    expectNamed(option.key());
}

TEST_F(Reference, EveryCommandIsInTheDocs) {
  const std::string docs = textOf("docs/command_line.md");
  for (const CommandSyntax& command : tool::commandSyntax(tool::CommandLine().app()).commands)
    EXPECT_NE(docs.find("`" + command.name + "`"), std::string::npos) << command.name;
}

TEST(NearestName, IsTheOneThatWasMeant) {
  const std::vector<std::string> names = {"render", "trace", "info", "explain"};
  EXPECT_EQ(detail::nearestName("tarce", names), "trace");
  EXPECT_EQ(detail::nearestName("rend", names), "render");
  EXPECT_EQ(detail::nearestName("explian", names), "explain");
  EXPECT_EQ(detail::nearestName("build", names), std::nullopt);
  EXPECT_EQ(detail::nearestName("x", names), std::nullopt);
}

TEST(NearestName, CountsLetters) {
  EXPECT_EQ(detail::editDistance("", ""), 0u);
  EXPECT_EQ(detail::editDistance("", "abc"), 3u);
  EXPECT_EQ(detail::editDistance("abc", ""), 3u);
  EXPECT_EQ(detail::editDistance("trace", "tarce"), 1u);
  EXPECT_EQ(detail::editDistance("kitten", "sitting"), 3u);
}

}  // namespace
}  // namespace planetree::test
