#include <planetree/planetree.hpp>

#include "exact/judged_answers.hpp"
#include "exact/judged_sets.hpp"
#include "support/build_variants.hpp"
#include "support/program_options.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

/// Puts rays to planetree and to the exact judge, and counts wrong answers.
namespace planetree::test {
namespace {

using Number = unsigned long long;

template <class T>
Verdicts judgeSet(const JudgedSet<T>& set, std::size_t rayCount, std::uint64_t salt) {
  const auto variants = buildVariants();
  const BuildOptions& options = variants[salt % variants.size()].second;
  const KdTree<Face<T>> tree = buildTree(set.mesh.view(), options);
  const std::vector<Ray<T>> rays = judgedRays(set.mesh, tree.bounds(), rayCount, salt);
  const std::vector<Answers<T>> answers = ask(tree, rays);
  AnswerJudge<T> judge(set.mesh, tree.bounds());
  Verdicts verdicts;
  for (std::size_t i = 0; i < rays.size(); ++i)
    judge.judge(rays[i], answers[i], verdicts);
  return verdicts;
}

void print(const char* scalar, const std::string& name, const Verdicts& v) {
  std::printf("%-6s %-45s %9llu %12llu %9llu %9llu | %9llu %9llu %9llu %5d | %5llu\n", scalar,
              name.c_str(), Number{v.rays}, Number{v.misses}, Number{v.hits}, Number{v.touchings},
              Number{v.certainPatches}, Number{v.openPatches}, Number{v.hitsChecked},
              v.farthestInRoundoffs, Number{v.wrongAnswers});
  for (const std::string& fault : v.firstFaults)
    std::printf("  wrong: %s\n", fault.c_str());
  std::fflush(stdout);
}

/// Judges each set with its part of the rays, in rounds of a size that memory holds.
template <class T>
Verdicts judgeSets(const char* scalar, const ProgramOptions& options) {
  constexpr std::uint64_t kMostRaysPerRound = 10'000;
  const std::vector<JudgedSet<T>> sets = judgedSets<T>();
  const std::uint64_t raysPerSet = std::max<std::uint64_t>(1, options.rays / 2 / sets.size());
  Verdicts total;
  std::uint64_t salt = options.seed * 1'000'000;
  for (const JudgedSet<T>& set : sets) {
    Verdicts ofSet;
    for (std::uint64_t done = 0; done < raysPerSet; done += kMostRaysPerRound) {
      const auto count = std::min(kMostRaysPerRound, raysPerSet - done);
      ofSet += judgeSet(set, static_cast<std::size_t>(count), salt += 10);
    }
    print(scalar, set.name, ofSet);
    ofSet.firstFaults.clear();
    total += ofSet;
  }
  print(scalar, "all", total);
  return total;
}

int judge(const ProgramOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  std::printf("planetree-judge: instruction set %s, seed %llu\n", options.instructionSet.c_str(),
              Number{options.seed});
  std::printf("%-6s %-45s %9s %12s %9s %9s | %9s %9s %9s %5s | %5s\n", "scalar", "set", "rays",
              "misses", "hits", "touching", "certain", "open", "checked", "u D", "wrong");
  const Verdicts floats = judgeSets<float>("float", options);
  const Verdicts doubles = judgeSets<double>("double", options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf(
      "%.0f seconds; reported points are at most %d u D (float) and %d u D (double) from "
      "their triangles\n",
      seconds.count(), floats.farthestInRoundoffs, doubles.farthestInRoundoffs);
  Verdicts total = floats;
  total += doubles;
  std::printf("exact judge: %llu rays, %llu pairs: %llu hits, %llu misses, %llu touching\n",
              Number{total.rays}, Number{total.hits + total.misses + total.touchings},
              Number{total.hits}, Number{total.misses}, Number{total.touchings});
  std::printf("wrong answers: %llu of %llu rays\n", Number{total.wrongAnswers}, Number{total.rays});
  return total.wrongAnswers == 0 ? 0 : 1;
}

}  // namespace
}  // namespace planetree::test

int main(int count, char** words) {
  bool isSkipped = false;
  const auto options = planetree::test::readProgramOptions(count, words, isSkipped);
  if (!options)
    return isSkipped ? 77 : 2;
  try {
    return planetree::test::judge(*options);
  } catch (const std::exception& error) {
    std::cerr << "planetree-judge: " << error.what() << '\n';
    return 2;
  }
}
