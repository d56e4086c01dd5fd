#include "core/files/text/atomic_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <stop_token>
#include <string>

using namespace forefront;
using forefront::testing::TemporaryFolder;

namespace {

std::string contentOf(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

TEST_CASE("AtomicFile: the complete file appears on commit, and nothing else") {
    const TemporaryFolder folder;
    AtomicFile file(folder / "a.txt");
    CHECK(file.write("first "));
    CHECK_FALSE(std::filesystem::exists(folder / "a.txt"));
    CHECK(file.write("second"));
    CHECK(file.commit().empty());
    CHECK(contentOf(folder / "a.txt") == "first second");
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("AtomicFile: without commit the old content stays and no temporary file remains") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.txt") << "old";
    {
        AtomicFile file(folder / "a.txt");
        CHECK(file.write("new"));
        CHECK(folder.fileCount() == 2);
    }
    CHECK(contentOf(folder / "a.txt") == "old");
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("AtomicFile: two writers of one name do not mix, and the last commit wins") {
    const TemporaryFolder folder;
    AtomicFile first(folder / "a.txt"), second(folder / "a.txt");
    CHECK(first.write("first"));
    CHECK(second.write("second"));
    CHECK(second.commit().empty());
    CHECK(first.commit().empty());
    CHECK(contentOf(folder / "a.txt") == "first");
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("AtomicFile: a link to a file that does not exist yet stays, and the file is made where it leads") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "meshes");
    std::filesystem::create_symlink("meshes/next", folder / "link");
    std::filesystem::create_symlink("a.txt", folder / "meshes" / "next");
    CHECK(writeFileAtomically(folder / "link", "new").empty());
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(std::filesystem::is_symlink(folder / "meshes" / "next"));
    CHECK(contentOf(folder / "meshes" / "a.txt") == "new");
    std::filesystem::create_symlink("loop", folder / "loop");
    CHECK_FALSE(writeFileAtomically(folder / "loop" / "a.txt", "new").empty());
}

TEST_CASE("AtomicFile: keeps the permissions of the previous file and follows links") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.txt") << "old";
    const auto expected = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
    std::filesystem::permissions(folder / "a.txt", expected);
    std::filesystem::create_symlink("a.txt", folder / "link");
    CHECK(writeFileAtomically(folder / "link", "new").empty());
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(contentOf(folder / "a.txt") == "new");
    CHECK(std::filesystem::status(folder / "a.txt").permissions() == expected);
}

TEST_CASE("AtomicFile: cancelling stops the writing and leaves the old file") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.txt") << "old";
    std::stop_source stop;
    Progress progress;
    progress.stop = stop.get_token();
    {
        AtomicFile file(folder / "a.txt", progress);
        CHECK(file.write("some"));
        stop.request_stop();
        CHECK_FALSE(file.write("more"));
        const Status status = file.commit();
        REQUIRE(status.size() == 1);
        CHECK(status[0].code == "cancelled");
    }
    CHECK(contentOf(folder / "a.txt") == "old");
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("AtomicFile: folders and missing folders are refused with path and reason") {
    const TemporaryFolder folder;
    for (const auto &path : {folder.path, folder / "missing/a.txt"}) {
        AtomicFile file(path);
        CHECK_FALSE(file.write("text"));
        const Status status = file.commit();
        REQUIRE(status.size() == 1);
        CHECK(status[0].code == "cannot-write");
        CHECK(status[0].file == path.string());
        CHECK(status[0].message.find(path.string()) != std::string::npos);
    }
    CHECK(folder.fileCount() == 0);
}
