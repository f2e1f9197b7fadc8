#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>

namespace planetree::detail {

/// The objects of a leaf as a range: turns each entry of a reference list into an object by asking
/// the tree. (Debian 12's clang cannot compile libstdc++'s std::views::transform.)
template <class Tree>
class LeafObjects {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using difference_type = std::ptrdiff_t;
    using reference = decltype(std::declval<const Tree&>().object(std::uint32_t{}));
    using value_type = std::remove_cvref_t<reference>;
    using pointer = void;

    Iterator() = default;
    Iterator(const Tree& tree, const std::uint32_t* number) noexcept
        : tree_(&tree), number_(number) {}

    reference operator*() const { return tree_->object(*number_); }
    Iterator& operator++() noexcept {
      ++number_;
      return *this;
    }
    Iterator operator++(int) noexcept {
      Iterator before = *this;
      ++number_;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) noexcept {
      return a.number_ == b.number_;
    }

   private:
    const Tree* tree_ = nullptr;
    const std::uint32_t* number_ = nullptr;
  };

  LeafObjects(const Tree& tree, std::span<const std::uint32_t> numbers) noexcept
      : tree_(&tree), numbers_(numbers) {}

  [[nodiscard]] Iterator begin() const noexcept { return {*tree_, numbers_.data()}; }
  [[nodiscard]] Iterator end() const noexcept {
    return {*tree_, numbers_.data() + numbers_.size()};
  }
  [[nodiscard]] std::size_t size() const noexcept { return numbers_.size(); }
  [[nodiscard]] bool empty() const noexcept { return numbers_.empty(); }

 private:
  const Tree* tree_;
  std::span<const std::uint32_t> numbers_;
};

}  // namespace planetree::detail
