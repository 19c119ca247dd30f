#include "cli/hand_ins.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class HandInsTest : public testing::Test {
 protected:
  std::string path(const std::string& inside) const { return folder_.path() / inside; }
  void write(const std::string& inside, const std::string& bytes) const {
    fs::create_directories(fs::path(path(inside)).parent_path());
    write_file(path(inside), bytes);
  }
  HandIns find(const std::vector<std::string>& names) const {
    std::vector<std::string> words;
    for (const std::string& name : names) words.push_back(path(name));
    return find_hand_ins(words);
  }
  // Without the folder of this test.
  std::vector<std::string> shown(std::vector<std::string> notes) const {
    for (std::string& note : notes) {
      for (std::size_t at; (at = note.find(path(""))) != note.npos;) {
        note.erase(at, path("").size());
      }
    }
    return notes;
  }

  const TemporaryFolder folder_;
};

using Notes = std::vector<std::string>;

TEST_F(HandInsTest, AreFoldersAndNothingElseEndsTheWork) {
  write("ann/fall.cpp", "");
  write("eva maria/fall.cpp", "");
  write("readme.txt", "");
  fs::create_directory_symlink("ann", path("bob"));
  const HandIns found = find({"ann", "eva maria/", "readme.txt", "bob/", "gone", "./ann"});
  ASSERT_EQ(found.all.size(), 3u);
  EXPECT_EQ(found.all[0].student, "ann");
  EXPECT_EQ(found.all[1].student, "eva maria");
  EXPECT_EQ(found.all[2].student, "bob");
  EXPECT_EQ(found.all[2].fault, "it is a link, and may lead to another's");
  EXPECT_EQ(shown(found.notes),
            (Notes{"readme.txt is no folder, and left out", "there is no folder gone",
                   "./ann is named twice, and graded once"}));
}

TEST_F(HandInsTest, OfOneNameAreToldApart) {
  write("monday/ann/fall.cpp", "");
  write("friday/Ann/fall.cpp", "");
  const HandIns found = find({"monday/ann", "friday/Ann"});
  ASSERT_EQ(found.all.size(), 2u);
  EXPECT_EQ(found.all[0].student, path("monday/ann"));
  EXPECT_EQ(shown(found.notes),
            (Notes{"these may be the same student, and each is graded: monday/ann, friday/Ann"}));
}

// "é" as one character, and as a letter with an accent; capitals beyond ASCII.
TEST_F(HandInsTest, OfOneNameToPeopleAreToldApart) {
  write("monday/ren\u00e9/fall.cpp", "");
  write("friday/RENe\u0301/fall.cpp", "");
  write("friday/rene/fall.cpp", "");
  const HandIns found = find({"monday/ren\u00e9", "friday/RENe\u0301", "friday/rene"});
  ASSERT_EQ(found.all.size(), 3u);
  EXPECT_EQ(found.all[2].student, "rene");
  EXPECT_EQ(shown(found.notes), (Notes{"these may be the same student, and each is graded: "
                                       "monday/ren\u00e9, friday/RENe\u0301"}));
}

TEST_F(HandInsTest, AreReadWithoutLinks) {
  write("ann/fall.cpp", "one\r\ntwo\rthree\n");
  write("bob/fall/fall.cpp", "text");
  fs::create_symlink("../ann/fall.cpp", path("bob/rise.cpp"));
  fs::create_directory_symlink("../bob/fall", path("ann/turn"));
  write("bob/fall/turn.cpp", "");
  EXPECT_EQ(read_handed_in({"ann", path("ann")}, "fall").text, "one\ntwo\rthree\n");
  EXPECT_EQ(read_handed_in({"bob", path("bob")}, "fall").text, "text");
  EXPECT_TRUE(read_handed_in({"bob", path("bob")}, "fall").changed);
  const std::string link = "it is a link, and may lead to another's";
  EXPECT_EQ(read_handed_in({"bob", path("bob")}, "rise").fault, link);
  EXPECT_EQ(read_handed_in({"ann", path("ann")}, "turn").fault, link);
  EXPECT_FALSE(read_handed_in({"ann", path("ann")}, "gone").is_there());
  EXPECT_FALSE(read_handed_in({"ann", path("ann"), "a fault"}, "fall").is_there());
}

TEST_F(HandInsTest, SayWhatIsWrongWithTheirText) {
  write("ann/one.cpp", std::string("\xff\xfe/\0/\0", 6));
  write("ann/two.cpp", "a\rb\r");
  write("ann/three.cpp", "\xef\xbb\xbfint x;\n");
  const HandIn ann{"ann", path("ann")};
  EXPECT_EQ(read_handed_in(ann, "one").fault, "it is no text in UTF-8: save it as such");
  EXPECT_EQ(read_handed_in(ann, "two").fault,
            "its lines end with carriage returns alone: save it with line feeds");
  EXPECT_EQ(read_handed_in(ann, "three").text, "int x;\n");
}

TEST_F(HandInsTest, HaveOneFileForAnExercise) {
  write("ann/fall.cpp", "");
  write("ann/fall/fall.cpp", "");
  EXPECT_EQ(notes_on({"ann", path("ann")}, {"fall"}),
            (Notes{"ann: fall.cpp is graded, and fall/fall.cpp is not"}));
  write("bob/Fall.cpp.txt", "");
  EXPECT_EQ(notes_on({"bob", path("bob")}, {"fall"}),
            (Notes{"bob: Fall.cpp.txt has the name of no exercise: is it fall.cpp?"}));
}

TEST_F(HandInsTest, AreNoResults) {
  write("results/students.csv", "");
  write("results/verdicts/a.json", "");
  const HandIns found = find({"results"});
  EXPECT_TRUE(found.all.empty());
  EXPECT_EQ(shown(found.notes), (Notes{"results has results, and is left out"}));
  EXPECT_EQ(find_hand_ins({path("results/..") + "/results/verdicts/."}).all[0].student, "verdicts");
}

TEST_F(HandInsTest, WithNamesThatMissTheirExerciseAreTold) {
  fs::create_directory(path("empty"));
  write("ann/rate.cpp", "");
  write("ann/my_l2_1_rate.CPP", "");
  write("ann/deep/er/l1_1_fall.cpp", "");
  write("ann/notes.txt", "");
  const std::vector<std::string> names{"l2_1_rate", "l1_1_fall"};
  EXPECT_EQ(notes_on({"empty", path("empty")}, names),
            (Notes{"empty: the folder is empty, or cannot be read"}));
  EXPECT_EQ(notes_on({"ann", path("ann")}, names),
            (Notes{"ann: deep/er/l1_1_fall.cpp is not where it is looked for: l1_1_fall.cpp, or "
                   "l1_1_fall/l1_1_fall.cpp",
                   "ann: my_l2_1_rate.CPP has the name of no exercise: is it l2_1_rate.cpp?",
                   "ann: rate.cpp has the name of no exercise: is it l2_1_rate.cpp?",
                   "ann: notes.txt is no NAME.cpp of an exercise"}));
  write("ann/l2_1_rate.cpp", "");
  write("ann/l1_1_fall.cpp", "");
  EXPECT_EQ(notes_on({"ann", path("ann")}, names), Notes{});
}

// As browsers and systems name a second download or a copy, and other ends of a program's name.
TEST_F(HandInsTest, WithNamesOfCopiesAreTold) {
  for (const std::string name : {"fall (1).cpp", "fall-1.cpp", "fall - Kopie.cpp", "Fall copy.CPP",
                                 "fall_2.cpp", "fall.cc", "fall.cpp.txt", "Copy of fall.cpp"}) {
    const TemporaryFolder ann;
    write_file(ann.path() / name, "");
    EXPECT_EQ(notes_on({"ann", ann.path()}, {"fall", "rise"}),
              (Notes{"ann: " + name + " has the name of no exercise: is it fall.cpp?"}));
  }
  write("ann/fall.zip", "");
  write("ann/falling.txt", "");
  write("ann/rise.cpp", "");
  EXPECT_EQ(notes_on({"ann", path("ann")}, {"fall", "rise"}),
            (Notes{"ann: fall.zip is an archive, and not looked into: unpack it"}));
}

TEST_F(HandInsTest, WithoutAnExerciseHaveANoteOnEachFile) {
  for (const char* name : {"a.txt", "b/c.pdf", "d.h", "e.md", "f.md", "g.md"}) {
    write(std::string("ann/") + name, "");
  }
  write("ann/z_fall.cpp", "");
  const std::string no = " is no NAME.cpp of an exercise";
  EXPECT_EQ(notes_on({"ann", path("ann")}, {"fall"}),
            (Notes{"ann: z_fall.cpp has the name of no exercise: is it fall.cpp?",
                   "ann: a.txt" + no, "ann: b/c.pdf" + no, "ann: d.h" + no, "ann: e.md" + no}));
}

}  // namespace
}  // namespace mjcourse
