#include "client/files/output_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

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
