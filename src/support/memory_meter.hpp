#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace planetree::detail {

/// Counts what a build takes of memory, and refuses more than it may have. Any thread may use it.
class MemoryMeter {
 public:
  /// A limit of 0 stands for the memory of the machine.
  explicit MemoryMeter(std::uint64_t limit);

  /// Throws `Error` with `MemoryLimitExceeded`, and counts nothing then.
  void add(std::size_t bytes);
  void remove(std::size_t bytes) noexcept;

  [[nodiscard]] std::uint64_t peak() const noexcept { return peak_; }

 private:
  std::uint64_t limit_;
  std::atomic<std::uint64_t> current_ = 0;
  std::atomic<std::uint64_t> peak_ = 0;
};

/// What one array, or a few of them, take; counted for as long as this lives.
class MemoryCharge {
 public:
  MemoryCharge() = default;
  MemoryCharge(MemoryMeter& meter, std::size_t bytes) : meter_(&meter), bytes_(bytes) {
    meter.add(bytes);
  }
  MemoryCharge(MemoryCharge&& other) noexcept
      : meter_(std::exchange(other.meter_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  MemoryCharge& operator=(MemoryCharge&& other) noexcept {
    std::swap(meter_, other.meter_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  /// Counts `bytes` from now on. Throws as `MemoryMeter::add` does, and changes nothing then.
  void resize(MemoryMeter& meter, std::size_t bytes) {
    if (bytes > bytes_)
      meter.add(bytes - bytes_);
    else
      meter.remove(bytes_ - bytes);
    meter_ = &meter;
    bytes_ = bytes;
  }
  ~MemoryCharge() {
    if (meter_ != nullptr)
      meter_->remove(bytes_);
  }

 private:
  MemoryMeter* meter_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace planetree::detail
