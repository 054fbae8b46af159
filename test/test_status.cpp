// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/status.h>

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace cgal_blend;

std::vector<Status> all_statuses() {
  std::vector<Status> all;
  for (int i = 0; i <= static_cast<int>(Status::result_invalid); ++i) all.push_back(static_cast<Status>(i));
  return all;
}

Diagnosis diagnosis(Status status, const std::string& detail = "") {
  Diagnosis d;
  d.status = status;
  d.detail = detail;
  return d;
}

double number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? std::nan("") : std::strtod(text.c_str() + at + words.size(), nullptr);
}

TEST(Status, Names_are_distinct_identifiers) {
  std::set<std::string> names;
  for (const Status status : all_statuses()) {
    const std::string text = name(status);
    EXPECT_TRUE(names.insert(text).second) << text;
    EXPECT_NE(text, "unknown");
    for (const char c : text) EXPECT_TRUE(std::islower(static_cast<unsigned char>(c)) || c == '_') << text;
  }
  EXPECT_STREQ(name(Status::input_not_closed), "input_not_closed");
}

TEST(Status, Descriptions_are_distinct_sentences_on_one_line) {
  std::set<std::string> sentences;
  for (const Status status : all_statuses()) {
    const std::string text = describe(status);
    EXPECT_TRUE(sentences.insert(text).second) << text;
    ASSERT_GT(text.size(), 10u);
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(text.front()))) << text;
    EXPECT_NE(text.back(), '.') << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

TEST(Status, Classes_are_the_exit_statuses_of_the_command_line) {
  for (const Status status : all_statuses()) {
    const std::string text = name(status);
    if (text.rfind("input_", 0) == 0) {
      EXPECT_EQ(status_class(status), Status_class::input) << text;
    }
  }
  EXPECT_EQ(static_cast<int>(status_class(Status::ok)), 0);
  EXPECT_EQ(static_cast<int>(status_class(Status::invalid_parameter)), 2);
  EXPECT_EQ(static_cast<int>(status_class(Status::input_empty)), 3);
  EXPECT_EQ(static_cast<int>(status_class(Status::radius_exceeds_face)), 4);
  EXPECT_EQ(static_cast<int>(status_class(Status::result_invalid)), 5);
}

TEST(Status, Only_ok_is_ok) {
  for (const Status status : all_statuses()) EXPECT_EQ(diagnosis(status).ok(), status == Status::ok);
}

TEST(Message, Tells_what_and_where_and_what_would_work) {
  Diagnosis d = diagnosis(Status::radius_exceeds_face, "edge 3-4");
  d.point = Diagnosis::Point(1, -2.5, 1e-7);
  d.max_radius = 0.75;
  EXPECT_EQ(message(d),
            std::string(describe(d.status)) + ": edge 3-4, at (1, -2.5, 1e-07); largest radius that works there: 0.75");
}

TEST(Message, Is_the_sentence_alone_if_nothing_else_is_known) {
  EXPECT_EQ(message(diagnosis(Status::input_empty)), describe(Status::input_empty));
}

TEST(Message, Stays_on_one_line) {
  EXPECT_EQ(message(diagnosis(Status::boolean_failed, "one\ntwo\r\nthree")).find_first_of("\r\n"), std::string::npos);
}

TEST(Message, Radius_is_never_rounded_up) {
  for (const double radius :
       {1.23456789, 0.99999999, 9.9999999, 1e-9 / 3, 123456789.0, 2.0 / 3 * 1e6, 5.0, 0.1, 1e300, 7e-300}) {
    Diagnosis d = diagnosis(Status::radius_exceeds_face);
    d.max_radius = radius;
    const double told = number_after(message(d), "works there: ");
    EXPECT_LE(told, radius);
    EXPECT_GE(told, radius * (1 - 2e-5));
  }
}

}  // namespace
