#include "client/files/output_file.hpp"

#include "client/files/descriptor.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace poolhall::files {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public ::testing::Test {
  protected:
    OutputFileTest() {
        std::string pattern = (fs::temp_directory_path() / "output_fileXXXXXX").string();
        folder = mkdtemp(pattern.data());
        file = folder / "a.csv";
    }

    ~OutputFileTest() override { fs::remove_all(folder); }

    [[nodiscard]] std::string text() const {
        std::ifstream in(file);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    void write(const std::string& content) const {
        OutputFile output(file);
        output.stream() << content;
        output.finish();
        EXPECT_FALSE(output.fault()) << *output.fault();
    }

    [[nodiscard]] struct stat status() const {
        struct stat found {};

        EXPECT_EQ(::stat(file.c_str(), &found), 0);
        return found;
    }

    /// What the function gives in a process without the rights of root, whose files may not grow
    /// beyond a size; -1 if that process did not come to it.
    template <class Body>
    static int as_ordinary_user(const Body& body, rlim_t max_bytes = RLIM_INFINITY) {
        constexpr uid_t kNobody = 65534;
        const pid_t child = fork();
        if (child == 0) {
            const rlimit limit{max_bytes, max_bytes};
            std::signal(SIGXFSZ, SIG_IGN);
            const bool limited = setrlimit(RLIMIT_FSIZE, &limit) == 0;
            const bool root = getuid() == 0 && max_bytes == RLIM_INFINITY;
            _exit(limited && (!root || setuid(kNobody) == 0) ? body() : 100);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    [[nodiscard]] std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    }

    fs::path folder;
    fs::path file;
};

TEST_F(OutputFileTest, TakesThePlaceOfAnOlderOneWhenItIsWhole) {
    std::ofstream(file) << "old";
    OutputFile output(file);
    output.stream() << "new" << std::flush;
    EXPECT_EQ(text(), "old");
    output.finish();
    EXPECT_FALSE(output.fault());
    EXPECT_EQ(text(), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, LeavesNothingWhenItIsNotFinished) {
    {
        OutputFile output(file);
        output.stream() << "new" << std::flush;
        EXPECT_EQ(files(), 1);
    }
    EXPECT_EQ(files(), 0);
}

TEST_F(OutputFileTest, SaysAtOnceWhereNothingCanBeWritten) {
    const fs::path nowhere = folder / "no" / "a.csv";
    EXPECT_EQ(OutputFile(nowhere).fault(),
              nowhere.string() + " cannot be written: No such file or directory");
    EXPECT_EQ(OutputFile(folder).fault(), folder.string() + " cannot be written: Is a directory");
}

TEST_F(OutputFileTest, SaysThatTheDiskIsFull) {
    // A device has no place to take; and this one is always full.
    OutputFile output("/dev/full");
    ASSERT_FALSE(output.fault());
    output.stream() << "new";
    output.finish();
    EXPECT_EQ(output.fault(), "/dev/full cannot be written: No space left on device");
    output.finish();
    EXPECT_EQ(output.fault(), "/dev/full cannot be written: No space left on device");
}

TEST_F(OutputFileTest, SaysThatTheDiskIsFullAfterMuchWasWritten) {
    OutputFile output("/dev/full");
    output.stream() << std::string(1'000'000, 'x');
    output.finish();
    EXPECT_EQ(output.fault(), "/dev/full cannot be written: No space left on device");
}

TEST_F(OutputFileTest, WritesTheTargetOfALinkAndLeavesTheLink) {
    const fs::path target = folder / "deep" / "target.csv";
    fs::create_directory(folder / "deep");
    fs::create_symlink("deep/second", file);
    fs::create_symlink("target.csv", folder / "deep" / "second");
    for (const char* content : {"dangling at first", "then there"}) {
        write(content);
        EXPECT_EQ(text(), content);
        EXPECT_TRUE(fs::is_symlink(file));
        EXPECT_TRUE(fs::is_symlink(folder / "deep" / "second"));
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(target)));
    }
}

TEST_F(OutputFileTest, SaysThatLinksGoRoundInACircle) {
    fs::create_symlink("b.csv", file);
    fs::create_symlink("a.csv", folder / "b.csv");
    EXPECT_EQ(OutputFile(file).fault(),
              file.string() + " cannot be written: Too many levels of symbolic links");
}

TEST_F(OutputFileTest, KeepsTheModeOfAnOlderFile) {
    for (const int mode : {0600, 0640, 0755, 0666}) {
        std::ofstream(file) << "old";
        fs::permissions(file, static_cast<fs::perms>(mode));
        write("new");
        EXPECT_EQ(text(), "new");
        EXPECT_EQ(static_cast<int>(fs::status(file).permissions()), mode);
    }
}

TEST_F(OutputFileTest, KeepsTheOwnerOfAnOlderFile) {
    if (getuid() != 0) GTEST_SKIP() << "only root can give files away";
    std::ofstream(file) << "old";
    ASSERT_EQ(chown(file.c_str(), 12345, 12346), 0);
    write("new");
    EXPECT_EQ(text(), "new");
    EXPECT_EQ(status().st_uid, 12345U);
    EXPECT_EQ(status().st_gid, 12346U);
}

TEST_F(OutputFileTest, GivesANewFileTheModeThatTheUmaskLeaves) {
    const mode_t umask_before = umask(027);
    write("new");
    umask(umask_before);
    EXPECT_EQ(status().st_mode & 07777U, 0640U);
}

TEST_F(OutputFileTest, KeepsASecretFromAllButItsOwner) {
    for (const bool older : {false, true}) {
        fs::remove(file);
        if (older) std::ofstream(file) << "old";
        OutputFile output(file, OutputFile::Readers::kOwnerOnly);
        output.stream() << "secret";
        output.finish();
        EXPECT_EQ(text(), "secret");
        EXPECT_EQ(status().st_mode & 07777U, 0600U);
    }
}

TEST_F(OutputFileTest, KeepsTheOtherNamesOfAFile) {
    std::ofstream(file) << "a longer old content";
    fs::create_hard_link(file, folder / "other");
    write("new");
    EXPECT_EQ(text(), "new");
    EXPECT_TRUE(fs::equivalent(file, folder / "other"));
}

TEST_F(OutputFileTest, OverwritesWhatItMayNotReplace) {
    std::ofstream(file) << "old";
    fs::permissions(file, static_cast<fs::perms>(0666));
    fs::permissions(folder, static_cast<fs::perms>(0555));
    EXPECT_EQ(as_ordinary_user([this] {
                  OutputFile output(file);
                  output.stream() << "new content";
                  if (text() != "old") return 1;
                  output.finish();
                  return output.fault() ? 2 : 0;
              }),
              0);
    EXPECT_EQ(text(), "new content");
    EXPECT_EQ(status().st_mode & 07777U, 0666U);
    fs::permissions(folder, static_cast<fs::perms>(0755));
}

TEST_F(OutputFileTest, LeavesAloneWhatItMayNotWrite) {
    std::ofstream(file) << "old";
    fs::permissions(file, static_cast<fs::perms>(0444));
    fs::permissions(folder, static_cast<fs::perms>(0777));
    EXPECT_EQ(as_ordinary_user([this] {
                  return OutputFile(file).fault() ==
                                 file.string() + " cannot be written: Permission denied"
                             ? 0
                             : 1;
              }),
              0);
    EXPECT_EQ(text(), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, WritesToTheEndOfWhatAProcessHasOpenAlready) {
    std::ofstream(file) << "before ";
    const Descriptor open(::open(file.c_str(), O_WRONLY | O_APPEND));
    const fs::path link = folder / "link";
    fs::create_symlink("/proc/self/fd/" + std::to_string(open.number()), link);
    OutputFile output(link);
    output.stream() << "new";
    output.finish();
    EXPECT_FALSE(output.fault());
    EXPECT_EQ(text(), "before new");
    EXPECT_TRUE(fs::is_symlink(link));
}

TEST_F(OutputFileTest, WritesToAPipe) {
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    const Descriptor reader(::open(file.c_str(), O_RDONLY | O_NONBLOCK));
    write("new");
    std::array<char, 16> read{};
    EXPECT_EQ(::read(reader.number(), read.data(), read.size()), 3);
    EXPECT_TRUE(fs::is_fifo(file));
}

TEST_F(OutputFileTest, ADiskThatIsFullChangesNothing) {
    // A limit of this process is met as a full disk is.
    for (const bool linked : {false, true}) {
        std::ofstream(file) << "old";
        if (linked) fs::create_hard_link(file, folder / "other");
        EXPECT_EQ(as_ordinary_user(
                      [this] {
                          OutputFile output(file);
                          output.stream() << std::string(1'000'000, 'x');
                          output.finish();
                          return output.fault() ? 0 : 1;
                      },
                      100'000),
                  0);
        EXPECT_EQ(text(), "old");
        EXPECT_EQ(files(), linked ? 2 : 1);
    }
}

TEST_F(OutputFileTest, KeepsWhatIsThereWhenItsPlaceCannotBeTaken) {
    OutputFile output(file);
    output.stream() << "new";
    fs::create_directory(file);
    std::ofstream(file / "in the way") << "old";
    output.finish();
    ASSERT_TRUE(output.fault());
    EXPECT_TRUE(output.fault()->starts_with(file.string() + " cannot be written: "))
        << *output.fault();
    EXPECT_TRUE(fs::exists(file / "in the way"));
}

}  // namespace
}  // namespace poolhall::files
