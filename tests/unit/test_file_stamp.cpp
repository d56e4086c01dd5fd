#include "core/files/source/file_stamp.hpp"
#include "core/files/source/source.hpp"
#include "tests/support/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <sys/stat.h>
#include <sys/time.h>

using namespace forefront;
using forefront::testing::TemporaryFolder;

namespace {

void fillFile(const std::filesystem::path &file, const std::string &text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// Sets the time of the last change, in seconds since 1970.
void setTime(const std::filesystem::path &file, long seconds) {
    const struct timeval times[2] = {{seconds, 0}, {seconds, 0}};
    REQUIRE(::utimes(file.c_str(), times) == 0);
}

} // namespace

TEST_CASE("FileStamp: tells another content, also of the same length and time, and a missing file") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.txt";
    CHECK(stampOf(file).kind == FileStamp::Kind::Missing);
    fillFile(file, "first");
    const FileStamp first = stampOf(file);
    CHECK(first.sameContent(stampOfContent("first")));
    CHECK_FALSE(first.settled); // just written: its time need not show the next change
    fillFile(file, "other");
    CHECK_FALSE(stampOf(file, first).sameContent(first));
    std::filesystem::remove(file);
    CHECK_FALSE(stampOf(file, first).sameContent(first));
}

TEST_CASE("FileStamp: an old file is read again only if its size, time or inode has changed") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.txt";
    fillFile(file, "first");
    setTime(file, 1'000'000);
    const FileStamp before = stampOf(file);
    CHECK(before.settled);
    FileStamp marked = before;
    marked.hash = 1; // would be replaced by reading
    CHECK(stampOf(file, marked).hash == 1);
    setTime(file, 1'000'001);
    CHECK(stampOf(file, marked).hash == before.hash);
}

TEST_CASE("FileStamp: pipes and folders are unknown, and a pipe is not waited for") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK_FALSE(stampOf(folder / "pipe").known());
    CHECK_FALSE(stampOf(folder.path).known());
    const Result<std::string> read = readRegularFile(folder / "pipe", 100);
    REQUIRE_FALSE(read.ok());
    CHECK(read.faults().front().code == "cannot-read");
    CHECK(readRegularFile("/dev/zero", 100).faults().front().message.find("device") != std::string::npos);
}
