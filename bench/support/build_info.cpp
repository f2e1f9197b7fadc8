#include "bench/support/build_info.hpp"

#include "planetree_bench_commit.hpp"

#include <sys/utsname.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace planetree::bench {

namespace {

std::string processorName() {
  std::ifstream processors("/proc/cpuinfo");
  for (std::string line; std::getline(processors, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  }
  return "unknown processor";
}

/// "6.1" of "6.1.0-13-amd64".
std::string majorAndMinor(const std::string& release) {
  const std::size_t second = release.find('.', release.find('.') + 1);
  return release.substr(0, second);
}

std::string systemName() {
  utsname names;
  if (::uname(&names) != 0)
    return "unknown system";
  return std::string(names.sysname) + " " + majorAndMinor(names.release);
}

}  // namespace

std::string commit() {
  return kCommit;
}

std::string compiler() {
  return PLANETREE_BENCH_COMPILER;
}

std::string buildType() {
  return PLANETREE_BENCH_BUILD_TYPE;
}

std::string machine() {
  return processorName() + ", " + std::to_string(hardwareThreads()) + " threads, " + systemName();
}

double loadAverage() {
  double average = -1.0;
  return ::getloadavg(&average, 1) == 1 ? average : -1.0;
}

unsigned hardwareThreads() {
  return std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace planetree::bench
