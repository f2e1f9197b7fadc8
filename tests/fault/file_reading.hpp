#pragma once

#include <functional>

namespace planetree::test {

/// While it lives, what is given is done before planetree's libraries read from a file for the
/// first time: the file is open then, and has been looked at.
class BeforeReading {
 public:
  explicit BeforeReading(std::function<void()> work);
  BeforeReading(const BeforeReading&) = delete;
  BeforeReading& operator=(const BeforeReading&) = delete;
  ~BeforeReading();
};

}  // namespace planetree::test
