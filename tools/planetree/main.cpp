#include "command_line.hpp"
#include "exit_status.hpp"
#include "interruption.hpp"
#include "output_file.hpp"
#include "standard_streams.hpp"
#include "talk.hpp"
#include "usage_error.hpp"

#include <csignal>
#include <exception>
#include <new>
#include <string>

namespace {

using namespace planetree::tool;

int say(int status, const std::string& message) {
  printToStandardError("planetree: " + message + "\n");
  return status;
}

/// Ends as programs do that leave closed pipes to the system: without a word, by the signal, so
/// that `planetree trace bunny.obj rays.csv | head` prints what it should and nothing else.
void endByClosedPipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
}

}  // namespace

int main(int argc, char** argv) {
  occupyClosedStreams();
  // A closed pipe and a file size limit are then errors of the write, and nothing half-written
  // stays.
  const bool isPipeWatched = std::signal(SIGPIPE, SIG_IGN) != SIG_IGN;
  std::signal(SIGXFSZ, SIG_IGN);
  endOnInterruption();
  try {
    return CommandLine().run(argc, argv);
  } catch (const UsageError& error) {
    return say(kWrongUsage, error.what());
  } catch (const ReaderLeft& error) {
    if (isPipeWatched)
      endByClosedPipe();
    return say(kFailed, error.what());
  } catch (const std::bad_alloc&) {
    return say(kFailed, "out of memory. Try a model with fewer triangles, or a smaller picture.");
  } catch (const std::exception& error) {
    return say(kFailed, error.what());
  }
}
