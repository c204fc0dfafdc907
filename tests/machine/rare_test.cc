#include "machine/base/rare.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace g31::rare_test {
namespace {

using Shared = std::shared_ptr<const std::string>;

/// How many own the text besides the caller.
long owners(const Shared& text) {
  return text.use_count() - 1;
}

TEST(Rare, IsNothingUnlessItIsGivenSomething) {
  const Rare<std::string> nothing;
  const Rare<std::string> none = std::nullopt;
  const Rare<std::string> text = std::string("late");
  EXPECT_FALSE(nothing.has_value());
  EXPECT_FALSE(none);
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "late");
  EXPECT_EQ(text->size(), 4U);
  EXPECT_EQ(sizeof text, sizeof(void*));
}

TEST(Rare, ACopyIsAnotherOneAndAMoveLeavesNothing) {
  Rare<std::string> text = std::string("late");
  Rare<std::string> copy = text;
  *copy += "r";
  EXPECT_EQ(*text, "late");
  const Rare<std::string> moved = std::move(copy);
  EXPECT_EQ(*moved, "later");
  EXPECT_FALSE(copy);  // NOLINT(bugprone-use-after-move): that is what is asked
  EXPECT_EQ(*std::exchange(text, std::nullopt), "late");
  EXPECT_FALSE(text);
}

TEST(Rare, EndsWhatItKeptOnce) {
  const Shared text = std::make_shared<const std::string>("late");
  {
    Rare<Shared> first = text;
    Rare<Shared> second = first;
    EXPECT_EQ(owners(text), 2);
    first = std::move(second);
    EXPECT_EQ(owners(text), 1);
    Rare<Shared>& same = first;
    first = same;
    EXPECT_EQ(owners(text), 1);
    EXPECT_EQ(*first, text);
    first = std::nullopt;
    EXPECT_EQ(owners(text), 0);
    first = text;
    const Shared taken = *std::move(first);
    EXPECT_EQ(owners(text), 1);
  }
  EXPECT_EQ(owners(text), 0);
}

}  // namespace
}  // namespace g31::rare_test
