#include "terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace planetree::test {

Terminal::Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)), slave_(-1) {
  std::array<char, 256> name{};
  if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0 ||
      ::ptsname_r(master_, name.data(), name.size()) != 0)
    throw std::runtime_error("no terminal");
  name_ = name.data();
  slave_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY);
}

Terminal::~Terminal() {
  ::close(slave_);
  ::close(master_);
}

std::string Terminal::readSome() const {
  constexpr int kMilliseconds = 20;
  std::string text;
  std::array<char, 4096> some{};
  pollfd waited{.fd = master_, .events = POLLIN, .revents = 0};
  while (::poll(&waited, 1, kMilliseconds) > 0) {
    const ssize_t count = ::read(master_, some.data(), some.size());
    if (count <= 0)
      break;
    text.append(some.data(), static_cast<std::size_t>(count));
  }
  return text;
}

}  // namespace planetree::test
