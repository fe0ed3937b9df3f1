// SPDX-License-Identifier: MPL-2.0
// The clogging log, fed with hand-made histories at a throat between two discs.
#include "analysis/clogging.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace porefines::analysis {
namespace {

using What = ClogEvent::What;

/// Throat of width 10 um at x = 100, y = 50 um between discs of radius 40 um; flow along x at 1 mm/s.
constexpr Real um = 1e-6;
constexpr Vec3 middle{100 * um, 50 * um, 10 * um};

Real gap_of_discs(const Vec3& x) {
  const Real r = 40 * um;
  return std::min(std::hypot(x.x - middle.x, x.y - middle.y - r - 5 * um),
                  std::hypot(x.x - middle.x, x.y - middle.y + r + 5 * um)) -
         r;
}

geom::PoreNetwork one_throat() {
  geom::PoreNetwork network;
  network.size = {200 * um, 100 * um, 20 * um};
  network.flat = true;
  network.pores.resize(2);
  geom::Throat throat;
  throat.centre = middle;
  throat.across = {0, 1, 0};
  throat.normal = {1, 0, 0};
  throat.width = 10 * um;
  throat.area = 200 * um * um;
  throat.behind = throat.ahead = 9 * um;
  throat.pore_behind = 0;
  throat.pore_ahead = 1;
  network.throats.push_back(throat);
  return network;
}

/// A run of which the test says where everybody is.
class Story {
 public:
  explicit Story(geom::PoreNetwork where = one_throat()) : network(std::move(where)) {
    rules.hold_time = 0.05;
  }
  /// A particle of diameter d [um] at x, y [um] with a speed [mm/s].
  void put(std::uint64_t id, Real d, Real x, Real y, Real speed = 0) {
    who[id] = {d * um / 2, {x * um, y * um, middle.z}, {speed * 1e-3, 0, 0}};
  }
  /// The next sample, 0.02 s later.
  std::vector<ClogEvent> tell(int times = 1) {
    std::vector<ClogEvent> events;
    for (int n = 0; n < times; ++n) {
      time += 0.02;
      auto news = update_clogging(state, sample(), network, rules);
      events.insert(events.end(), news.begin(), news.end());
    }
    return events;
  }
  [[nodiscard]] Fate fate(std::uint64_t id) const {
    return state.fates[static_cast<std::size_t>(std::distance(who.begin(), who.find(id)))];
  }

  struct One {
    Real radius;
    Vec3 x;
    Vec3 v;
  };
  geom::PoreNetwork network;
  RestRules rules;
  CloggingState state;
  std::map<std::uint64_t, One> who;
  Real time = 0;
  Index out = 0;

 private:
  RunSample sample() {
    ids.clear(), xs.clear(), vs.clear(), rs.clear(), gaps.clear(), normals.clear();
    for (const auto& [id, one] : who) {
      const WallTouch touch = touch_wall(gap_of_discs, one.x, one.radius);
      ids.push_back(id), xs.push_back(one.x), vs.push_back(one.v), rs.push_back(one.radius);
      gaps.push_back(touch.gap), normals.push_back(touch.normal);
    }
    return {time, 2 * time, 1e-3, out, ids, xs, vs, rs, gaps, normals};
  }
  std::vector<std::uint64_t> ids;
  std::vector<Vec3> xs, vs, normals;
  std::vector<Real> rs, gaps;
};

/// Two particles of 7 um across the throat, each on its disc: 6.9 um apart, upstream of the middle.
void put_arch(Story& story, std::uint64_t first) {
  // the discs' surfaces 13.9 um apart: at x = -sqrt(45^2 - (40 + 3.5)^2 ...) each touches its disc
  const Real y = 3.47;
  const Real x = std::sqrt(43.5 * 43.5 - (45 - y) * (45 - y));
  story.put(first, 7, 100 - x, 50 + y);
  story.put(first + 1, 7, 100 - x, 50 - y);
}

}  // namespace

TEST(Clogging, one_too_large_is_sieved_at_once_after_the_time_it_must_hold) {
  Story story;
  story.put(3, 12, 40, 50, 1);
  story.put(4, 5, 60, 50, 1);
  EXPECT_TRUE(story.tell(4).empty());
  const Real x = std::sqrt(46.0 * 46 - 45.0 * 45);  // touches both discs
  story.put(3, 12, 100 - x, 50);
  EXPECT_TRUE(story.tell(3).empty());  // 0.04 s so far
  const auto events = story.tell();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].what, What::clogged);
  EXPECT_EQ(events[0].clog.kind, ClogKind::sieve);
  EXPECT_EQ(events[0].clog.throat, 0);
  EXPECT_EQ(events[0].clog.ids, std::vector<std::uint64_t>{3});
  EXPECT_DOUBLE_EQ(events[0].time, 0.16);
  EXPECT_DOUBLE_EQ(events[0].pore_volumes, 0.32);
  EXPECT_EQ(story.fate(3), Fate::clogged);
  EXPECT_EQ(story.fate(4), Fate::piping);
  story.out = 2;
  EXPECT_TRUE(story.tell(5).empty());
  EXPECT_EQ(story.state.counts.piping, 3);
  EXPECT_DOUBLE_EQ(story.state.counts.share(story.state.counts.clogged), 0.25);
}

TEST(Clogging, two_that_span_the_throat_are_an_arch_and_a_third_behind_them_makes_it_grow) {
  Story story;
  put_arch(story, 10);
  auto events = story.tell(6);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].clog.kind, ClogKind::arch);
  EXPECT_EQ(events[0].clog.ids, (std::vector<std::uint64_t>{10, 11}));
  EXPECT_EQ(events[0].clog.behind, 0);
  EXPECT_EQ(story.fate(10), Fate::bridging);
  const Real x = story.who[10].x.x / um;
  story.put(12, 7, x - 6, 50);  // leans on both
  story.put(13, 7, x - 13, 50);
  events = story.tell(6);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].what, What::grown);
  EXPECT_EQ(events[0].clog.behind, 2);
  EXPECT_EQ(story.fate(12), Fate::clogged);
  EXPECT_EQ(story.fate(13), Fate::clogged);
  EXPECT_EQ(story.state.counts.bridging, 2);
}

TEST(Clogging, is_released_when_an_arch_breaks_and_may_clog_again) {
  Story story;
  put_arch(story, 10);
  EXPECT_EQ(story.tell(6).size(), 1U);
  story.put(10, 7, 130, 50, 1);
  auto events = story.tell();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].what, What::released);
  EXPECT_EQ(events[0].clog.ids, (std::vector<std::uint64_t>{10, 11}));
  EXPECT_EQ(story.fate(10), Fate::piping);
  EXPECT_EQ(story.fate(11), Fate::resting);
  story.who.erase(10);
  EXPECT_TRUE(story.tell(3).empty());
  put_arch(story, 20);
  story.who.erase(11);
  events = story.tell(6);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].what, What::clogged);
  EXPECT_EQ(events[0].clog.ids, (std::vector<std::uint64_t>{20, 21}));
}

TEST(Clogging, a_member_whose_place_another_holds_as_well_releases_nothing) {
  Story story;
  put_arch(story, 10);
  story.put(12, 7, story.who[10].x.x / um, story.who[10].x.y / um);
  EXPECT_EQ(story.tell(6).size(), 1U);
  EXPECT_EQ(story.state.clogs[0].ids, (std::vector<std::uint64_t>{10, 11, 12}));
  story.put(10, 7, 130, 50, 1);
  EXPECT_TRUE(story.tell().empty());
  EXPECT_EQ(story.state.clogs[0].ids, (std::vector<std::uint64_t>{11, 12}));
  EXPECT_NEAR(story.state.clogs[0].since, 0.08, 1e-12);
  story.put(11, 7, 130, 50, 1);
  EXPECT_EQ(story.tell().size(), 1U);
}

TEST(Clogging, an_arch_near_two_throats_clogs_the_nearer_one) {
  geom::PoreNetwork network = one_throat();
  network.throats.push_back(network.throats[0]);
  network.throats[0].centre.x -= 30 * um;
  Story story(network);
  put_arch(story, 10);  // 17 um behind the first, 13 um before the second
  const auto events = story.tell(8);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].clog.throat, 1);
  EXPECT_EQ(story.state.clogs.size(), 1U);
}

TEST(Clogging, a_large_one_on_a_wall_before_a_throat_is_not_sieved) {
  Story story;
  story.network.throats[0].centre.x += 40 * um;  // 49 um to the throat at x = 140
  story.network.throats[0].behind = 5 * um;
  story.put(1, 9, 115, 50 + 45 - std::sqrt(44.5 * 44.5 - 15 * 15));
  EXPECT_TRUE(story.tell(8).empty());
  EXPECT_EQ(story.fate(1), Fate::resting);
}

TEST(Clogging, three_in_a_round_throat_are_one_arch) {
  geom::PoreNetwork network = one_throat();
  network.flat = false;
  const Real radius = 5 * um;
  network.throats[0].width = 2 * radius;
  network.throats[0].area = 3.1416 * radius * radius;
  CloggingState state;
  std::vector<std::uint64_t> ids{5, 6, 7, 8};
  std::vector<Vec3> xs, vs(4), normals;
  for (int n = 0; n < 3; ++n) {  // touch each other and the wall, 3 um before the centre
    const Real angle = 0.4 + n * 2 * 3.14159265 / 3;
    const Vec3 out{0, std::cos(angle), std::sin(angle)};
    xs.push_back(middle + Vec3{-3 * um, 0, 0} + (2.2 / std::sqrt(3.0) * 2 * um) * out);
    normals.push_back(-0.9 * out - Vec3{0.43589, 0, 0});
  }
  xs.push_back(middle + Vec3{-6 * um, 0, 0});  // behind all three
  normals.push_back({});
  const std::vector<Real> rs(4, 2.2 * um);
  const std::vector<Real> gaps{0, 0, 0, 1};
  std::vector<ClogEvent> events;
  for (int n = 0; n < 5; ++n) {
    const RunSample sample{0.02 * n, 0, 1e-3, 0, ids, xs, vs, rs, gaps, normals};
    auto news = update_clogging(state, sample, network, {.hold_time = 0.05});
    events.insert(events.end(), news.begin(), news.end());
  }
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].clog.ids, (std::vector<std::uint64_t>{5, 6, 7}));
  EXPECT_EQ(events[0].clog.behind, 1);
}

TEST(Clogging, jitter_at_the_threshold_writes_nothing_twice) {
  Story story;
  put_arch(story, 10);
  EXPECT_EQ(story.tell(6).size(), 1U);
  const Real x = story.who[10].x.x / um;
  for (int n = 0; n < 200; ++n) {  // around the stop speed of 0.01 mm/s, far above it, in place
    story.put(10, 7, x + 0.3 * std::sin(2.1 * n), 53.47, n % 3 == 0 ? 0.05 : 0.0099);
    EXPECT_TRUE(story.tell().empty()) << n;
  }
  EXPECT_EQ(story.state.clogs.size(), 1U);
}

TEST(Clogging, one_that_begins_to_rest_may_waver_up_to_twice_the_stop_speed) {
  for (const Real wavers : {0.019, 0.021}) {
    Story story;
    put_arch(story, 10);
    std::size_t events = 0;
    for (int n = 0; n < 12; ++n) {
      story.who[10].v.x = (n % 2 == 0 ? 0.009 : wavers) * 1e-3;
      events += story.tell().size();
    }
    EXPECT_EQ(events, wavers < 0.02 ? 1U : 0U) << wavers;
  }
}

TEST(Clogging, one_in_a_dead_corner_is_retained_but_clogs_nothing) {
  Story story;
  story.put(1, 5, 100 + 30, 50 + 45 - std::sqrt(42.5 * 42.5 - 30 * 30));  // on the back of a disc
  story.put(2, 5, 30, 20);  // stopped in the open, held by nothing
  EXPECT_TRUE(story.tell(20).empty());
  EXPECT_EQ(story.fate(1), Fate::resting);
  EXPECT_EQ(story.fate(2), Fate::piping);
  EXPECT_TRUE(story.state.clogs.empty());
}

TEST(Clogging, two_side_by_side_on_the_same_wall_are_no_arch) {
  Story story;
  for (const int n : {0, 1}) {
    const Real angle = 0.08 + n * 7.0 / 43.5;
    story.put(static_cast<std::uint64_t>(n), 7, 100 - 43.5 * std::sin(angle),
              50 + 45 - 43.5 * std::cos(angle));
  }
  EXPECT_TRUE(story.tell(10).empty());
  EXPECT_EQ(story.fate(0), Fate::resting);
}

TEST(Clogging, a_clog_across_a_periodic_face_is_found) {
  geom::PoreNetwork network = one_throat();
  network.periodic = {true, true, false};
  Story story(network);
  put_arch(story, 10);
  for (auto& [id, one] : story.who) {
    one.x.x -= 200 * um;  // the same place, one period before
  }
  story.rules.contact_gap = 1e3;        // the discs of this test have no images: everything touches
  EXPECT_EQ(story.tell(6).size(), 0U);  // no wall normal out there: no support
  for (auto& [id, one] : story.who) {
    one.x.x += 200 * um;
  }
  EXPECT_EQ(story.tell(6).size(), 1U);
}

TEST(Clogging, goes_on_from_its_packed_state_as_if_nothing_had_happened) {
  Story whole;
  put_arch(whole, 10);
  (void)whole.tell(4);
  whole.put(12, 7, whole.who[10].x.x / um - 6, 50);
  (void)whole.tell(2);
  Story again = whole;
  again.state = unpack_clogging(pack(whole.state));
  for (int n = 0; n < 6; ++n) {
    const auto a = whole.tell();
    const auto b = again.tell();
    EXPECT_EQ(clogging_rows(a, whole.network), clogging_rows(b, again.network));
  }
  EXPECT_EQ(pack(whole.state), pack(again.state));
  auto numbers = pack(whole.state);
  numbers.pop_back();
  EXPECT_THROW((void)unpack_clogging(numbers), RunError);
}

TEST(Clogging, row_says_when_where_how_and_who) {
  Story story;
  put_arch(story, 10);
  const auto events = story.tell(6);
  const std::string rows = clogging_rows(events, story.network);
  EXPECT_EQ(rows, "0.08,0.16,0,0.0001,5e-05,1e-05,1e-05,clogged,arch,2,0,0,10 11\n");
  EXPECT_EQ(clogging_columns().size(), 13U);
}

TEST(Clogging, everybody_finds_its_own_throat_among_thousands) {
  // 50 x 50 throats, two resting at each: every particle finds its one throat
  geom::PoreNetwork network = one_throat();
  const geom::Throat throat = network.throats[0];
  network.throats.clear();
  std::vector<std::uint64_t> ids;
  std::vector<Vec3> xs, vs, normals;
  std::vector<Real> rs, gaps;
  for (int k = 0; k < 2500; ++k) {
    geom::Throat one = throat;
    one.centre += Vec3{k / 50 * 100 * um, k % 50 * 100 * um, 0};
    network.throats.push_back(one);
    for (const Real side : {-1.0, 1.0}) {
      ids.push_back(ids.size());
      xs.push_back(one.centre + Vec3{-5 * um, side * 3.4 * um, 0});
      vs.push_back({});
      rs.push_back(3.5 * um);
      gaps.push_back(0);
      normals.push_back({-0.6, -0.8 * side, 0});
    }
  }
  network.size = {5100 * um, 5100 * um, 20 * um};
  CloggingState state;
  std::size_t events = 0;
  for (int n = 1; n <= 3; ++n) {
    const RunSample sample{0.1 * n, 0, 1e-3, 0, ids, xs, vs, rs, gaps, normals};
    events += update_clogging(state, sample, network, {.hold_time = 0.05}).size();
  }
  EXPECT_EQ(events, 2500U);
  EXPECT_EQ(state.counts.bridging, 5000);
  EXPECT_EQ(state.rest.pairs.size(), 2500U);
}

}  // namespace porefines::analysis
