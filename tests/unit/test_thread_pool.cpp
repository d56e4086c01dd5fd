#include "core/engine/base/free_memory.hpp"
#include "core/engine/base/thread_pool.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace forefront;

TEST_CASE("ThreadPool: executes each task exactly once for any number of threads and tasks") {
    for (const unsigned threads : {0U, 1U, 2U, 3U, 8U}) {
        ThreadPool pool(threads);
        CHECK(pool.threads() == std::max(1U, threads));
        for (const std::size_t tasks : {0U, 1U, 2U, 7U, 1000U}) {
            std::vector<std::atomic<int>> done(tasks);
            std::atomic<bool> known = true;
            pool.run(tasks, [&](std::size_t task, unsigned thread) {
                ++done[task];
                known = known && thread < pool.threads();
            });
            CHECK(std::all_of(done.begin(), done.end(), [](const std::atomic<int> &d) { return d == 1; }));
            CHECK(known);
        }
    }
}

TEST_CASE("ThreadPool: data written by the tasks is visible when run returns") {
    ThreadPool pool(3);
    std::vector<int> numbers(1 << 16);
    for (int round = 1; round <= 50; ++round) {
        pool.forChunks(numbers.size(), 1000, [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t i = begin; i < end; ++i) {
                numbers[i] += round;
            }
        });
    }
    CHECK(std::accumulate(numbers.begin(), numbers.end(), 0LL) == 1275LL << 16);
}

TEST_CASE("ThreadPool: chunks are the same for any number of threads and cover the range") {
    ThreadPool one(1), four(4);
    for (const std::size_t count : {0U, 1U, 99U, 100U, 101U, 1050U}) {
        std::vector<std::size_t> ends[2] = {std::vector<std::size_t>(11), std::vector<std::size_t>(11)};
        int which = 0;
        for (ThreadPool *pool : {&one, &four}) {
            pool->forChunks(count, 100, [&, which](std::size_t begin, std::size_t end, std::size_t chunk) {
                CHECK(begin == 100 * chunk);
                ends[which][chunk] = end;
            });
            ++which;
        }
        CHECK(ends[0] == ends[1]);
        CHECK(*std::max_element(ends[0].begin(), ends[0].end()) == count);
    }
}

TEST_CASE("ThreadPool: begins no task after a stop and remains usable") {
    for (const unsigned threads : {1U, 2U, 4U}) {
        ThreadPool pool(threads);
        for (const std::size_t stopAt : {0U, 5U}) {
            std::stop_source stop;
            std::atomic<std::size_t> begun = 0, late = 0;
            if (stopAt == 0) {
                stop.request_stop();
            }
            pool.run(
                1000,
                [&](std::size_t, unsigned) {
                    late += stop.stop_requested() ? 1 : 0;
                    if (++begun == stopAt) {
                        stop.request_stop();
                    }
                },
                stop.get_token());
            CHECK(begun >= stopAt);
            CHECK((stopAt > 0 || begun == 0));
            CHECK(late < threads); // a thread beside the one that stops may have taken a task just before
            begun = 0;
            pool.run(100, [&](std::size_t, unsigned) { ++begun; });
            CHECK(begun == 100);
        }
    }
}

TEST_CASE("ThreadPool: rethrows a task's exception to the caller and remains usable") {
    ThreadPool pool(2);
    CHECK_THROWS_AS(pool.run(100,
                             [](std::size_t task, unsigned) {
                                 if (task == 42) {
                                     throw std::runtime_error("task");
                                 }
                             }),
                    std::runtime_error);
    std::atomic<int> count = 0;
    pool.run(100, [&](std::size_t, unsigned) { ++count; });
    CHECK(count == 100);
}

// With the address sanitizer, the allocator of the C library is set up by the first of these calls.
TEST_CASE("Free memory: threads may release it at the same time, the first call included") {
    constexpr int kThreads = 8;
    std::atomic<int> ready = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i) {
        threads.emplace_back([&ready] {
            ++ready;
            while (ready < kThreads) {
                std::this_thread::yield();
            }
            releaseFreeMemory();
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    CHECK(ready == kThreads);
}
