#include "question/passed_places.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

using Places = std::vector<std::uint32_t>;

/// Adds `count` questions that come through these places.
void add(PassedPlaces& seen, std::size_t count, bool wrong, const Places& places)
{
    for (std::size_t i = 0; i < count; ++i) seen.push_back({.wrong = wrong, .places = places});
}

Places numbers(const std::vector<PartingPlace>& found)
{
    Places all;
    for (const PartingPlace& one : found) all.push_back(one.place);
    return all;
}

TEST(PassedPlaces, those_that_only_wrong_ones_come_through_are_found_in_their_order)
{
    PassedPlaces seen;
    add(seen, 20, false, {1, 2, 9});
    add(seen, 5, true, {1, 7, 3, 9});
    const std::vector<PartingPlace> found = parting_places(seen);
    ASSERT_EQ(numbers(found), (Places{7, 3, 2}));
    EXPECT_TRUE(found[0].of_wrong);
    EXPECT_FALSE(found[2].of_wrong);
    EXPECT_EQ(found[0].wrong_through, 5U);
    EXPECT_EQ(found[0].right, 20U);
    EXPECT_EQ(found[2].right_through, 20U);
}

TEST(PassedPlaces, a_place_that_right_ones_alone_come_through_is_found)
{
    PassedPlaces seen;
    add(seen, 20, false, {1, 2, 9});
    add(seen, 5, true, {1, 9});
    EXPECT_EQ(numbers(parting_places(seen)), (Places{2}));
}

TEST(PassedPlaces, what_follows_a_call_that_is_left_by_an_exception_is_none)
{
    PassedPlaces seen;
    add(seen, 20, false, {1, 2, 9});
    add(seen, 5, true, {1, 9});
    seen[3].by_exception = true;
    EXPECT_EQ(numbers(parting_places(seen)), (Places{2})) << "in a right one it says nothing";
    seen[22].by_exception = true;
    EXPECT_TRUE(parting_places(seen).empty());
}

// A polygon that is left off too early leaves off where one does that has nothing in the window.
TEST(PassedPlaces, those_that_have_nothing_to_do_may_be_left_out)
{
    PassedPlaces seen;
    add(seen, 20, false, {1, 2, 9});
    add(seen, 6, false, {1, 7});
    add(seen, 5, true, {1, 2, 7, 9});
    EXPECT_EQ(numbers(parting_places(without_idle(seen))), numbers(parting_places(seen))) << "none is known to be";
    EXPECT_TRUE(parting_places(seen).empty());
    for (std::size_t i = 20; i < 26; ++i) seen[i].idle = true;
    const PassedPlaces busy = without_idle(seen);
    EXPECT_EQ(busy.size(), 25U);
    EXPECT_EQ(numbers(parting_places(busy)), (Places{7}));
}

// A sphere's distances are all wrong, and what misses it is right: the return of a distance parts them, and is no bug.
TEST(PassedPlaces, where_an_answer_is_given_is_known_apart)
{
    PassedPlaces seen;
    add(seen, 3, false, {1, 2});
    add(seen, 3, true, {1, 3});
    EXPECT_FALSE(are_wrong_where_given(seen)) << "nothing is known of that";
    for (PassedQuestion& one : seen) one.given = one.wrong;
    EXPECT_TRUE(are_wrong_where_given(seen));
    seen[0].given = true;
    EXPECT_FALSE(are_wrong_where_given(seen)) << "one that was given an answer is right";
}

TEST(PassedPlaces, what_all_or_some_of_both_come_through_is_none)
{
    PassedPlaces seen;
    add(seen, 12, false, {1, 2});
    add(seen, 8, false, {1});
    add(seen, 6, true, {1, 2});
    add(seen, 4, true, {1});
    EXPECT_TRUE(parting_places(seen).empty());
}

TEST(PassedPlaces, a_few_right_ones_may_come_along)
{
    PassedPlaces seen;
    add(seen, 198, false, {1});
    add(seen, 2, false, {1, 4});
    add(seen, 12, true, {1, 4});
    ASSERT_EQ(numbers(parting_places(seen)), (Places{4}));
    // More of them say that it is where such questions go.
    add(seen, 2, false, {1, 4});
    EXPECT_TRUE(parting_places(seen).empty());
}

TEST(PassedPlaces, few_of_either_are_parted_by_chance)
{
    PassedPlaces seen;
    add(seen, 5, false, {1});
    add(seen, 3, true, {1, 4});
    EXPECT_TRUE(parting_places(seen).empty());
    add(seen, 1, true, {1, 4});
    EXPECT_TRUE(parting_places(seen).empty());
    add(seen, 1, false, {1});
    EXPECT_FALSE(parting_places(seen).empty());
}

TEST(PassedPlaces, others_tell_whether_it_holds)
{
    PassedPlaces seen;
    add(seen, 20, false, {1});
    add(seen, 5, true, {1, 4});
    const PartingPlace found = parting_places(seen).front();
    PassedPlaces others;
    add(others, 10, false, {1});
    add(others, 3, true, {1, 4});
    EXPECT_TRUE(parts(place_among(found, others)));
    EXPECT_EQ(strays_of(place_among(found, others)), (std::pair<double, double>(0, 0)));
    add(others, 3, true, {1});
    EXPECT_FALSE(parts(place_among(found, others)));
    EXPECT_EQ(strays_of(place_among(found, others)), (std::pair<double, double>(0.5, 0)));
    add(others, 10, false, {1, 4});
    EXPECT_EQ(strays_of(place_among(found, others)), (std::pair<double, double>(0.5, 0.5)));
}

}
}
