#include "core/files/files.hpp"
#include "core/files/text/file_set.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace forefront;
using forefront::testing::TemporaryFolder;

namespace {

std::string bytesOf(const std::filesystem::path &file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Files cannot become longer while the object lives, as on a full disc.
class LimitedFiles {
  public:
    explicit LimitedFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        REQUIRE(::getrlimit(RLIMIT_FSIZE, &before_) == 0);
        const struct rlimit limit { bytes, before_.rlim_max };
        REQUIRE(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
    }
    ~LimitedFiles() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    LimitedFiles(const LimitedFiles &) = delete;
    LimitedFiles &operator=(const LimitedFiles &) = delete;

  private:
    void (*handler_)(int);
    struct rlimit before_ {};
};

/// Returns the number of a process that has ended.
pid_t endedProcess() {
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(0);
    }
    REQUIRE(child > 0);
    REQUIRE(::waitpid(child, nullptr, 0) == child);
    return child;
}

} // namespace

TEST_CASE("FileSet: no file appears before all are complete, and then all do") {
    const TemporaryFolder folder;
    std::ofstream(folder / "b") << "old";
    FileSet files;
    CHECK(files.write(folder / "a", "first"));
    CHECK(files.write(folder / "b", "second"));
    CHECK_FALSE(std::filesystem::exists(folder / "a"));
    CHECK(bytesOf(folder / "b") == "old");
    CHECK(files.commit().empty());
    CHECK(bytesOf(folder / "a") == "first");
    CHECK(bytesOf(folder / "b") == "second");
    CHECK(folder.fileCount() == 2);
}

TEST_CASE("FileSet: if the nth file fails, none is replaced and nothing is left behind") {
    constexpr std::size_t kCount = 4;
    for (std::size_t failing = 0; failing < kCount; ++failing) {
        const TemporaryFolder folder;
        const auto name = [&](std::size_t k) { return folder / std::to_string(k); };
        for (std::size_t k = 0; k < kCount; ++k) {
            std::ofstream(name(k)) << "old";
        }
        {
            const LimitedFiles limit(1000);
            FileSet files;
            for (std::size_t k = 0; k < kCount; ++k) {
                CHECK(files.write(name(k), std::string(k == failing ? 2000 : 500, 'x')) == (k < failing));
            }
            const Status status = files.commit();
            REQUIRE(status.size() == 1);
            CHECK(status[0].code == "cannot-write");
            CHECK(status[0].file == name(failing).string());
            CHECK((status[0].message.find("not replaced either") != std::string::npos) == (failing > 0));
        }
        CHECK(folder.fileCount() == kCount);
        for (std::size_t k = 0; k < kCount; ++k) {
            CHECK(bytesOf(name(k)) == "old");
        }
    }
}

TEST_CASE("FileSet: if a file cannot get its name, those that have theirs are taken back") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "old";
    FileSet files;
    CHECK(files.write(folder / "a", "new"));
    CHECK(files.write(folder / "b", "new"));
    CHECK(files.write(folder / "c", "new"));
    std::filesystem::create_directory(folder / "c"); // in the way
    const Status status = files.commit();
    REQUIRE(status.size() == 1);
    CHECK(status[0].file == (folder / "c").string());
    CHECK(bytesOf(folder / "a") == "old");
    CHECK_FALSE(std::filesystem::exists(folder / "b"));
    CHECK(folder.fileCount() == 1); // without the folder in the way
}

TEST_CASE("Triangle: a disc that is full keeps the old files of a mesh together") {
    const TemporaryFolder folder;
    const TriMesh small = samples::square(2, 2), large = samples::square(40, 40);
    REQUIRE(writeMesh(folder / "plate.node", small, "triangle").empty());
    const std::string nodes = bytesOf(folder / "plate.node"), elements = bytesOf(folder / "plate.ele");
    {
        const TemporaryFolder other;
        REQUIRE(writeMesh(other / "plate.node", large, "triangle").empty());
        const auto nodeBytes = std::filesystem::file_size(other / "plate.node");
        const auto elementBytes = std::filesystem::file_size(other / "plate.ele");
        REQUIRE(nodeBytes < elementBytes);
        const LimitedFiles limit((nodeBytes + elementBytes) / 2);
        const Status status = writeMesh(folder / "plate.node", large, "triangle");
        REQUIRE(status.size() == 1);
        CHECK(status[0].file == (folder / "plate.ele").string());
    }
    CHECK(bytesOf(folder / "plate.node") == nodes);
    CHECK(bytesOf(folder / "plate.ele") == elements);
    CHECK(folder.fileCount() == 3);
}

TEST_CASE("Triangle: files of different meshes are not read as one") {
    const TemporaryFolder folder;
    REQUIRE(writeMesh(folder / "a.node", samples::square(2, 2), "triangle").empty());
    REQUIRE(writeMesh(folder / "b.node", samples::square(3, 3), "triangle").empty());
    REQUIRE(readMesh(folder / "a.node").ok());
    for (const char *extension : {"ele", "edge"}) {
        std::filesystem::copy_file(folder / "a.node", folder / "c.node",
                                   std::filesystem::copy_options::overwrite_existing);
        for (const char *each : {"ele", "edge"}) {
            const std::string from = std::string(each == std::string_view(extension) ? "b." : "a.") + each;
            std::filesystem::copy_file(folder / from, folder / (std::string("c.") + each),
                                       std::filesystem::copy_options::overwrite_existing);
        }
        const Result<Mesh> mixed = readMesh(folder / "c.node");
        REQUIRE_FALSE(mixed.ok());
        CHECK(mixed.faults().front().code == "mixed-files");
        CHECK(mixed.faults().front().file == (folder / (std::string("c.") + extension)).string());
    }
}

TEST_CASE("AtomicFile: a link to a file that does not exist yet stays, and its target is written") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "below");
    std::filesystem::create_symlink("middle", folder / "link");
    std::filesystem::create_symlink("below/target", folder / "middle");
    CHECK(writeFileAtomically(folder / "link", "new").empty());
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(std::filesystem::is_symlink(folder / "middle"));
    CHECK(bytesOf(folder / "below/target") == "new");

    std::filesystem::create_symlink("missing/target", folder / "lost");
    const Status status = writeFileAtomically(folder / "lost", "new");
    REQUIRE(status.size() == 1);
    CHECK(status[0].code == "cannot-write");
    CHECK(std::filesystem::is_symlink(folder / "lost"));
}

TEST_CASE("AtomicFile: a write-protected file is refused, by its own name and through a link") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a") << "old";
    std::filesystem::permissions(folder / "a", std::filesystem::perms::owner_read);
    std::filesystem::create_symlink("a", folder / "link");
    for (const char *name : {"a", "link"}) {
        const Status status = writeFileAtomically(folder / name, "new");
        REQUIRE(status.size() == 1);
        CHECK(status[0].message.find("write-protected") != std::string::npos);
        CHECK(status[0].file == (folder / name).string());
        CHECK_FALSE(checkPlace(folder / name).empty());
    }
    CHECK(bytesOf(folder / "a") == "old");
    CHECK(folder.fileCount() == 2);
}

TEST_CASE("AtomicFile: temporary files of killed programs are removed, those of running ones and others are not") {
    const TemporaryFolder folder;
    const std::string dead = std::to_string(endedProcess()), alive = std::to_string(::getppid());
    const std::vector<std::string> names{"a.msh." + dead + "-0.tmp", "a.msh." + dead + "-3.tmp.old.tmp"};
    const std::vector<std::string> kept{"a.msh." + alive + "-0.tmp", "b.msh." + dead + "-0.tmp", "a.msh.tmp",
                                        "a.msh." + dead + "-0.txt", "a.msh.old-1.tmp"};
    for (const std::string &name : names) {
        std::ofstream(folder / name) << "half";
    }
    for (const std::string &name : kept) {
        std::ofstream(folder / name) << "mine";
    }
    CHECK(writeFileAtomically(folder / "a.msh", "whole").empty());
    for (const std::string &name : names) {
        CHECK_FALSE(std::filesystem::exists(folder / name));
    }
    for (const std::string &name : kept) {
        CHECK(bytesOf(folder / name) == "mine");
    }
}
