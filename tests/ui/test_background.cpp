#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/ui/edit_driver.hpp"
#include "ui/background/background_task.hpp"
#include "ui/background/file_watch.hpp"
#include "ui/background/latest.hpp"
#include "ui/dialogs/export_dialog.hpp"
#include "ui/dialogs/thumbnails.hpp"
#include "ui/workspace/mesh/mesh_judge.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <vector>

namespace forefront::test {

namespace {

/// Holds up workers until it is opened for their request.
class WorkerGate {
  public:
    void open(int request) {
        const std::lock_guard lock(mutex_);
        open_ = std::max(open_, request);
        changed_.notify_all();
    }
    /// Waits until the work on a request has begun.
    void awaitBegin(int request) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return begun_ >= request; });
    }
    /// Waits until the work on a request has ended.
    void awaitEnd(int request) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return ended_ >= request; });
    }
    void pass(int request) {
        std::unique_lock lock(mutex_);
        begun_ = std::max(begun_, request);
        changed_.notify_all();
        changed_.wait(lock, [&] { return open_ >= request; });
        ended_ = std::max(ended_, request);
        changed_.notify_all();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int open_ = 0, begun_ = 0, ended_ = 0;
};

using Doubler = Latest<int, int>;

/// Work that doubles its request once the gate is open, and marks the answer of a stopped one with a sign.
Doubler::Work gated(const std::shared_ptr<WorkerGate> &gate) {
    return [gate](const Doubler::Turn &turn) {
        gate->pass(turn.request);
        return turn.stop.stop_requested() ? -2 * turn.request : 2 * turn.request;
    };
}

void awaitRest(const BackgroundList &list, const std::function<void()> &refresh) {
    while (!list.atRest()) {
        refresh();
        std::this_thread::yield();
    }
}

/// An activity in a state that a test sets.
class SetActivity final : public BackgroundActivity {
  public:
    using BackgroundActivity::BackgroundActivity;
    bool working() const override { return works; }
    bool hasNews() const override { return news; }
    bool works = false, news = false;
};

template <class Worker>
constexpr bool kOnlyInList =
    std::is_base_of_v<BackgroundActivity, Worker> && !std::is_default_constructible_v<Worker> &&
    !std::is_copy_constructible_v<Worker> && !std::is_move_constructible_v<Worker>;

// A worker cannot be made without the list of its window, or leave it.
static_assert(kOnlyInList<Doubler>);
static_assert(kOnlyInList<FileWatch>);
static_assert(kOnlyInList<RunControl>);
static_assert(kOnlyInList<SideBySide>);
static_assert(!std::is_constructible_v<Doubler, Doubler::Work>);
static_assert(!std::is_default_constructible_v<BackgroundTask> && !std::is_copy_constructible_v<BackgroundTask>);
static_assert(!std::is_default_constructible_v<Adaptation> && !std::is_copy_constructible_v<Adaptation>);

} // namespace

TEST_CASE("Background: activities are in the list of their window as long as they exist") {
    BackgroundList list([] {});
    {
        const Doubler doubler(list, [](const Doubler::Turn &turn) { return turn.request; });
        const FileWatch watch(list);
        const BackgroundTask task(list);
        const MeshJudge judge(list);
        const Adaptation adaptation(list);
        const DocumentExaminer examiner(list);
        const Thumbnails thumbnails(list, {});
        CHECK(list.size() == 8); // the examiner has one more, which plans the rows of layers
        CHECK(list.atRest());
    }
    CHECK(list.size() == 0);
}

TEST_CASE("Background: a file is not watched where no thread can be started, and the next one tries again") {
    BackgroundList list([] {});
    bool starts = false;
    FileWatch watch(list, [&starts](std::function<void()> run) {
        if (!starts) {
            throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
        }
        return startThread(std::move(run));
    });
    watch.watch("first.json", {});
    CHECK(watch.file().empty());
    watch.lookNow();
    CHECK_FALSE(watch.takeNews());
    starts = true;
    watch.watch("second.json", {});
    CHECK(watch.file() == "second.json");
}

TEST_CASE("Background: a file that cannot be written for lack of memory is reported") {
    Draughtsman driver;
    const auto write = [](const Progress &) -> Diagnostics { throw std::bad_alloc(); };
    bool written = false;
    driver.context().dialogs.open(std::make_unique<WriteDialog>(driver.context().background, "part.msh", write,
                                                                [&written](Shell &) { written = true; }));
    driver.settle();
    CHECK(driver.logHas("out-of-memory"));
    CHECK_FALSE(written);
    CHECK(driver.editor().settled());
}

TEST_CASE("Background: the window counts the workers of its dialogs, and rests when they do") {
    Draughtsman driver;
    const std::size_t before = driver.context().background.size();
    driver.context().actions.run("file.samples", driver.context());
    CHECK(driver.context().background.size() == before + 1);
    CHECK_FALSE(driver.editor().settled());
    driver.settle();
    CHECK(driver.context().background.atRest());
    driver.key(key::kEscape);
    driver.settle();
    CHECK(driver.context().background.size() == before);
}

TEST_CASE("Background: news draws a frame when its pace allows, and the window rests without work and news") {
    BackgroundList list([] {});
    const auto never = [](NewsPace) { return false; };
    const auto always = [](NewsPace) { return true; };
    for (const NewsPace pace : {NewsPace::AtOnce, NewsPace::WithMesh, NewsPace::WithPreview, NewsPace::WhenUsed}) {
        SetActivity activity(list, pace);
        CHECK(list.atRest());
        activity.works = true;
        CHECK_FALSE(list.atRest());
        CHECK_FALSE(list.hasNews(always));
        activity.works = false;
        activity.news = true;
        const bool awaited = pace != NewsPace::WhenUsed;
        CHECK(list.atRest() != awaited);
        CHECK(list.hasNews(always) == awaited);
        CHECK(list.hasNews([pace](NewsPace due) { return due == pace; }) == awaited);
        CHECK_FALSE(list.hasNews(never));
    }
}

TEST_CASE("Background: of the requests that wait, only the newest is answered on the thread") {
    std::atomic<int> wakes = 0;
    BackgroundList list([&] {
        ++wakes;
        wakes.notify_one();
    });
    const auto gate = std::make_shared<WorkerGate>();
    Doubler doubler(list, gated(gate));
    doubler.submit(1);
    gate->awaitBegin(1);
    doubler.submit(2);
    doubler.submit(3);
    CHECK(doubler.working());
    CHECK_FALSE(doubler.hasNews());
    gate->open(1);
    gate->awaitBegin(3);
    CHECK(doubler.refresh()); // the one under way is finished and shown
    CHECK(doubler.now() == 2);
    CHECK(doubler.working());
    gate->open(3);
    doubler.wait();
    CHECK_FALSE(doubler.working());
    CHECK(doubler.refresh());
    CHECK(doubler.now() == 6);
    CHECK_FALSE(doubler.refresh());
    CHECK(list.atRest());
    doubler.submit(2); // a further one starts again
    doubler.wait();
    CHECK(doubler.refresh());
    CHECK(doubler.now() == 4);
    while (wakes < 3) { // the window is woken after the answer
        wakes.wait(wakes);
    }
    CHECK(wakes == 3);
}

TEST_CASE("Background: a worker on a thread shows answers before the last, each after the one before") {
    BackgroundList list([] {});
    using Collector = Latest<int, std::vector<int>>;
    Collector collector(list, [](const Collector::Turn &turn) {
        std::vector<int> answer = turn.earlier;
        answer.push_back(turn.request);
        turn.publish(answer);
        answer.push_back(-turn.request);
        return answer;
    });
    for (const int request : {1, 2}) {
        collector.submit(request);
        collector.wait();
    }
    CHECK(collector.refresh());
    CHECK(collector.now() == std::vector<int>{1, -1, 2, -2});
    collector.clear({7});
    CHECK(collector.now() == std::vector<int>{7});
    CHECK_FALSE(collector.refresh());
    collector.submit(3);
    collector.wait();
    CHECK(collector.refresh());
    CHECK(collector.now() == std::vector<int>{7, 3, -3});
}

TEST_CASE("Background: what was cancelled is stopped on its thread, and its answer never arrives") {
    std::atomic<int> wakes = 0;
    BackgroundList list([&] { ++wakes; });
    const auto gate = std::make_shared<WorkerGate>();
    const auto later = std::make_shared<WorkerGate>();
    later->open(9);
    std::atomic<bool> stopped = false;
    Doubler doubler(list, [&, gate, later](const Doubler::Turn &turn) {
        (turn.request == 1 ? gate : later)->pass(turn.request);
        stopped = stopped || turn.stop.stop_requested();
        return 2 * turn.request;
    });
    doubler.submit(1);
    gate->awaitBegin(1);
    doubler.submit(5); // waits
    doubler.cancel();
    CHECK(list.atRest());
    doubler.submit(4); // does not wait for the thread that hangs
    doubler.wait();
    CHECK(doubler.refresh());
    CHECK(doubler.now() == 8);
    CHECK_FALSE(stopped);
    gate->open(1);
    gate->awaitEnd(1);
    while (!stopped) {
        std::this_thread::yield();
    }
    while (wakes == 0) { // the answer can be fetched shortly before the window is woken for it
        std::this_thread::yield();
    }
    CHECK_FALSE(doubler.refresh());
    CHECK(doubler.now() == 8);
    CHECK(wakes == 1);
}

TEST_CASE(
    "Background: an answer that arrived but was not fetched is dropped by a cancel, for threads that have ended") {
    BackgroundList list([] {});
    Doubler doubler(
        list, [](const Doubler::Turn &turn) { return 2 * turn.request; }, -1);
    doubler.submit(1);
    doubler.wait();
    CHECK(doubler.hasNews());
    doubler.cancel();
    CHECK_FALSE(doubler.hasNews());
    CHECK(doubler.now() == -1);
}

TEST_CASE("Background: the answer of work that was only stopped on its thread still counts") {
    BackgroundList list([] {});
    const auto gate = std::make_shared<WorkerGate>();
    Doubler doubler(list, gated(gate));
    doubler.submit(1);
    gate->awaitBegin(1);
    doubler.submit(2);
    doubler.requestStop();
    gate->open(9);
    doubler.wait();
    CHECK(doubler.refresh());
    CHECK(doubler.now() == -2); // and the request that waited is dropped
    doubler.submit(3);
    doubler.wait();
    CHECK(doubler.refresh());
    CHECK(doubler.now() == 6); // the stop was for the earlier one
}

TEST_CASE("Background: without a thread, the caller answers its own request") {
    BackgroundList list([] {});
    const std::thread::id caller = std::this_thread::get_id();
    bool same = false;
    Doubler doubler(
        list,
        [&](const Doubler::Turn &turn) {
            same = std::this_thread::get_id() == caller;
            return 2 * turn.request;
        },
        0, Doubler::kForever, NewsPace::AtOnce,
        [](const std::function<void()> &) -> std::thread {
            throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
        });
    doubler.submit(4);
    CHECK(same);
    CHECK_FALSE(doubler.working());
    CHECK(doubler.refresh());
    CHECK(doubler.now() == 8);
}

TEST_CASE("Background: a thread that hangs in a reader is left behind at the end, and wakes no window that is gone") {
    const auto gate = std::make_shared<WorkerGate>();
    std::atomic<int> wakes = 0;
    {
        BackgroundList list([&] { ++wakes; });
        Doubler doubler(list, gated(gate), 0, std::chrono::milliseconds(20));
        doubler.submit(1);
        gate->awaitBegin(1);
    }
    gate->open(1);
    gate->awaitEnd(1);
    while (gate.use_count() > 1) { // the thread shares it until it has ended
        std::this_thread::yield();
    }
    CHECK(wakes == 0);
}

TEST_CASE("Background: the end waits for a thread that would use what ends with it") {
    const auto gate = std::make_shared<WorkerGate>();
    std::thread opener;
    {
        BackgroundList list([] {});
        Doubler doubler(list, gated(gate));
        doubler.submit(1);
        gate->awaitBegin(1);
        opener = std::thread([&gate] { gate->open(1); });
    }
    CHECK(gate.use_count() == 1);
    opener.join();
}

TEST_CASE("Background: results about a document that was replaced are dropped by the examiner's thread") {
    BackgroundList list([] {});
    DocumentExaminer examiner(list);
    Shape plate;
    plate.form = CircleForm();
    plate.nodes = {{0, 0}, {4, 0}};
    const Result<Document> document = addShape(Document(), plate);
    REQUIRE(document);
    const auto drawn = std::make_shared<SharedDomain>(std::make_shared<const Document>(*document));
    const auto refresh = [&examiner] { examiner.refresh(); };
    examiner.submit(drawn, 5, std::make_shared<SharedSpacing>());
    examiner.abandon();
    awaitRest(list, refresh);
    CHECK(examiner.preview()->revision == 0);
    examiner.submitRaster({{0, 0}, {4, 4}}, 3, 2);
    examiner.submit(drawn, 6, std::make_shared<SharedSpacing>());
    awaitRest(list, refresh);
    CHECK(examiner.preview()->revision == 6);
    CHECK(examiner.preview()->spacing != nullptr);
    CHECK(examiner.raster()->revision == 6);
    CHECK(examiner.raster()->rho.size() == 6);
    examiner.submitRaster({{0, 0}, {4, 4}}, 4, 2); // of the same preview
    awaitRest(list, refresh);
    CHECK(examiner.raster()->rho.size() == 8);
    CHECK(examiner.preview()->revision == 6);
}

TEST_CASE("Background: a task reports what it does, and a second one replaces it on another thread") {
    BackgroundList list([] {});
    BackgroundTask task(list);
    const auto gate = std::make_shared<WorkerGate>();
    std::string used;
    task.start("reading one", [gate, &used](const Progress &progress) {
        progress("one, halfway", 0.5);
        gate->pass(1);
        return BackgroundTask::Finish([&used] { used += "one"; });
    });
    CHECK(task.busy());
    CHECK(task.name() == "reading one");
    gate->awaitBegin(1);
    CHECK(task.refresh());
    CHECK(task.name() == "one, halfway");
    CHECK(task.fraction() == 0.5);
    task.start("reading two", [&used](const Progress &) { return BackgroundTask::Finish([&used] { used += "two"; }); });
    CHECK(task.purpose() == "reading two");
    gate->open(1);
    awaitRest(list, [&task] { task.refresh(); });
    REQUIRE(task.ready());
    CHECK(task.busy()); // until the result has been used
    task.finish();
    CHECK_FALSE(task.busy());
    CHECK(used == "two");
}

} // namespace forefront::test
