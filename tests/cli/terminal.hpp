#pragma once

#include <string>

namespace planetree::test {

/// A terminal that nobody looks at.
class Terminal {
 public:
  Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal();

  /// The file that programs open to write to it.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// What has been written since the last call, or is soon.
  [[nodiscard]] std::string readSome() const;

 private:
  int master_;
  int slave_;  ///< kept open, so that what was written stays there to be read
  std::string name_;
};

}  // namespace planetree::test
