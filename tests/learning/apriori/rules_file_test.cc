// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/rules_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/check.h"
#include "core/random.h"

namespace pacer::affordance {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TransactionDatabase parse(const std::string& text) {
  std::istringstream in(text);
  return read_transactions(in, "drives.txt");
}

std::string refusal(const std::string& text) {
  try {
    (void)parse(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

class RulesFile : public ::testing::Test {
 protected:
  RulesFile() { std::filesystem::create_directories(folder); }
  ~RulesFile() override { std::filesystem::remove_all(folder); }
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) /
      ("rules_file_" +
       std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(RulesFile, ReadsATransactionALine) {
  const TransactionDatabase database = parse("0 5 17 539\n2 1\n");
  ASSERT_EQ(database.size(), 2U);
  EXPECT_THAT(database.transaction(0), ElementsAre(5, 17, 539));
  EXPECT_THAT(database.transaction(1), ElementsAre(1));
  EXPECT_THAT(database.types, ElementsAre(0, 2));
  EXPECT_THAT(database.stretches, ElementsAre(0, 1));
  EXPECT_EQ(database.item_count, 540);
  EXPECT_EQ(database.type_count, 3);
}

TEST_F(RulesFile, SortsItemsAndDropsRepeatedOnes) {
  EXPECT_THAT(parse("1 9 3 9 0 3").transaction(0), ElementsAre(0, 3, 9));
}

TEST_F(RulesFile, PassesOverBlanksBlankLinesAndAMissingLastNewline) {
  const TransactionDatabase database = parse("\n  \t\n 1\t2  3 \r\n\r\n\n0\n1 4");
  ASSERT_EQ(database.size(), 3U);
  EXPECT_THAT(database.transaction(0), ElementsAre(2, 3));
  EXPECT_THAT(database.transaction(1), IsEmpty());
  EXPECT_THAT(database.transaction(2), ElementsAre(4));
  EXPECT_EQ(parse("").size(), 0U);
}

TEST_F(RulesFile, RefusesWhatIsNoNumberWithItsLine) {
  EXPECT_THAT(refusal("0 1\n\n0 1 x\n"), StartsWith("drives.txt:3: "));
  EXPECT_THAT(refusal("0 1\n\n0 1 x\n"), HasSubstr("`x`"));
  EXPECT_THAT(refusal("0 -1"), HasSubstr("`-`"));
  EXPECT_THAT(refusal("0 1.5"), HasSubstr("`.`"));
  EXPECT_THAT(refusal("0, 1"), HasSubstr("`,`"));
  EXPECT_THAT(refusal(std::string("0 1\0", 4)), HasSubstr("0x00"));
  EXPECT_THAT(refusal("\xef\xbb\xbf"
                      "0 1"),
              HasSubstr("0xef"));
}

TEST_F(RulesFile, RefusesNumbersThatAreTooLarge) {
  EXPECT_EQ(refusal("255 65535"), "");
  EXPECT_THAT(refusal("0 1\n256 1"), StartsWith("drives.txt:2: the action type is above 255"));
  EXPECT_THAT(refusal("0 65536"), HasSubstr("an item is above 65535"));
  EXPECT_THAT(refusal("0 99999999999999999999999999999999"), HasSubstr("above 65535"));
  EXPECT_THAT(refusal(std::string(1'000'000, '9')), HasSubstr("above 255"));
  EXPECT_EQ(refusal("0 " + std::string(1'000'000, '0') + "7"), "");
}

TEST_F(RulesFile, RefusesALineOfMoreItemsThanThereCanBe) {
  std::string text = "0";
  for (int i = 0; i < 65536; ++i) text += " 1";
  EXPECT_EQ(refusal(text), "");
  EXPECT_THAT(refusal(text + " 1"), HasSubstr("more than 65536 items"));
}

TEST_F(RulesFile, AnswersAnyBytesWithADatabaseOrOneLine) {
  Random random(9);
  const std::string likely = "0123456789 \n\t\rx-.";
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text;
    const std::uint64_t kinds = trial % 2 == 0 ? 14 : likely.size();
    for (std::uint64_t left = random.below(60); left > 0; --left) {
      text +=
          random.chance(0.01) ? static_cast<char>(random.below(256)) : likely[random.below(kinds)];
    }
    try {
      const TransactionDatabase database = parse(text);
      ASSERT_EQ(database.offsets.size(), database.size() + 1);
      (void)mine_rules(database, AprioriConfig{.support_percent = 1.0});
    } catch (const UsageError& error) {
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST_F(RulesFile, NamesTheFileThatCannotBeRead) {
  EXPECT_THAT([&] { (void)read_transactions(folder / "none.txt"); },
              ::testing::ThrowsMessage<UsageError>(HasSubstr("none.txt: cannot be read: No such")));
  EXPECT_THAT([&] { (void)read_transactions(folder); },
              ::testing::ThrowsMessage<UsageError>(HasSubstr("is a folder")));
}

TEST_F(RulesFile, WritesRulesSortedAsNumbersWithCountAndConfidence) {
  const std::vector<Rule> rules = {
      {10, {1, 2}, 7, 7}, {2, {3, 20}, 199, 200}, {2, {3, 4, 500}, 2, 3}, {2, {3, 4}, 5, 7}};
  write_rules(folder / "rules.txt", rules);
  std::ifstream in(folder / "rules.txt");
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(),
            "2 3 4 5 0.714286\n"
            "2 3 4 500 2 0.666667\n"
            "2 3 20 199 0.995000\n"
            "10 1 2 7 1.000000\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "rules.txt.part"));
}

TEST_F(RulesFile, NamesTheFileThatCannotBeWritten) {
  std::ofstream(folder / "file") << "not a folder";
  EXPECT_THAT([&] { write_rules(folder / "file" / "rules.txt", {}); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  HasSubstr("rules.txt: cannot be written: Not a directory")));
  EXPECT_THAT([&] { write_rules("/dev/full/rules.txt", {}); },
              ::testing::Throws<std::runtime_error>());
}

}  // namespace
}  // namespace pacer::affordance
