#include "bench/support/batches.hpp"

#include "bench/support/answer_check.hpp"

#include <utility>

namespace planetree::bench {

namespace {

class SingleRays final : public Batch {
 public:
  SingleRays(const Structure& structure, const RaySet& set)
      : structure_(structure), set_(set), answers_(roomForAnswers(set)) {}

  void trace(unsigned threadCount) override {
    takeAnswers(structure_, set_, threadCount, answers_);
  }
  void readAnswers(Answers& answers) const override { answers = answers_; }

 private:
  const Structure& structure_;
  const RaySet& set_;
  Answers answers_;
};

}  // namespace

std::unique_ptr<Batch> oneByOne(const Structure& structure, const RaySet& set) {
  return std::make_unique<SingleRays>(structure, set);
}

std::unique_ptr<Batch> allAtOnce(const Structure& structure, const RaySet& set) {
  auto batch = structure.makeBatch(set, set.rays.size());
  return batch ? std::move(batch) : oneByOne(structure, set);
}

}  // namespace planetree::bench
