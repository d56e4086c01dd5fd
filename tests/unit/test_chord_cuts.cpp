#include "core/drawing/arrangement/curves/chord_cuts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace forefront;

namespace {

Chord chordOf(const Curve &curve, double t0, double t1) {
    return {CurvePart(curve, t0, t1), curve.point(t0), curve.point(t1), 0};
}

/// Short arcs around the origin, all within a tolerance.
std::vector<Chord> arcsAtOnePlace(int count, double radius) {
    std::vector<Chord> chords;
    for (int k = 0; k < count; ++k) {
        chords.push_back(chordOf(Curve::circle({}, {radius, 0.0}), 0.01 * k, 0.01 * k + 0.1));
    }
    return chords;
}

} // namespace

TEST_CASE("findChordCuts: chords that are too small to be divided are not compared with each other") {
    constexpr int kCount = 50;
    std::vector<Chord> chords = arcsAtOnePlace(kCount, 0.3);
    CHECK(findChordCuts(chords, 1.0, {}).comparisons == 0);
    chords.push_back(chordOf(Curve::quadratic({-20.0, 0.0}, {0.0, 20.0}, {20.0, 0.0}), 0.0, 1.0));
    CHECK(findChordCuts(chords, 1.0, {}).comparisons == kCount);
}

TEST_CASE("findChordCuts: lists what it finds by chords, whether few or all of them are fresh") {
    // Arcs side by side; the last one crosses all others.
    std::vector<Chord> chords;
    for (int k = 0; k < 12; ++k) {
        chords.push_back(chordOf(Curve::quadratic({3.0 * k, 0.0}, {3.0 * k + 1.0, 5.0}, {3.0 * k, 10.0}), 0.0, 1.0));
        chords.back().fresh = false;
    }
    chords.push_back(chordOf(Curve::quadratic({-5.0, 4.0}, {16.0, 6.0}, {40.0, 4.0}), 0.0, 1.0));
    const ChordCuts few = findChordCuts(chords, 1e-9, {});
    for (Chord &chord : chords) {
        chord.fresh = true;
    }
    const ChordCuts all = findChordCuts(chords, 1e-9, {});
    REQUIRE(few.meetings.size() == 12);
    REQUIRE(all.meetings.size() == 12);
    for (std::uint32_t k = 0; k < all.meetings.size(); ++k) {
        CHECK(all.meetings[k].chord == k);
        CHECK(std::count_if(few.meetings.begin(), few.meetings.end(),
                            [&](const ChordMeeting &meeting) { return meeting.chord == k; }) == 1);
    }
}
