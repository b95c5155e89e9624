// Points in text: separators, decimal marks, headings, and what is left out of them.
#include "test_apps_clouds.h"

#include <cmath>
#include <string>
#include <vector>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

class Text : public testing::Test
{
protected:
  TestFolder folder;

  InputCloud read (const std::string& text) const { return readCloud (folder.write ("a.txt", text)); }

  /** \brief Why the text is refused, without the file's name; empty if it is not. */
  std::string error (const std::string& text) const
  {
    const std::string file = folder.write ("a.txt", text);
    const std::string message = readingError (file);
    return message.empty () ? message : message.substr (file.size () + 2);
  }

  /** \brief All values, a point after the other, and the names of the fields. */
  static std::string valuesOf (const InputCloud& input)
  {
    std::string text;
    for (std::size_t i = 0; i < input.size (); ++i) {
      for (const pcl::PCLPointField& field : input.cloud.fields)
        text +=
          std::to_string (static_cast<int> (std::lround (100 * valueAt (input.cloud, field.name, i)))) + " ";
      text += "| ";
    }
    return text;
  }

  static std::string namesOf (const InputCloud& input)
  {
    std::string text;
    for (const pcl::PCLPointField& field : input.cloud.fields)
      text += field.name + " ";
    return text;
  }

  static std::string lines (int count, const std::string& line)
  {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += line;
    return text;
  }
};

} // namespace

TEST_F (Text, HasOneSeparatorAFile)
{
  for (const char* const text :
       {"1.5 2 3 4\n5 6.25 7 8\n", "1.5,2,3,4\n5,6.25,7,8\n", "1.5, 2, 3, 4\n5,6.25 ,7,8\n",
        "1.5;2;3;4\n5;6.25;7;8\n", "1.5\t2\t3\t4\r\n5\t6.25\t7\t8", " 1.5 2  3\t4\n5 6.25 7 8",
        "1.5; 2; 3; 4;\n5; 6.25; 7; 8;\n", "\xEF\xBB\xBF#c\n1.5 2 3 4# tail\n\n5 6.25 7 8\n"}) {
    const InputCloud input = read (text);
    EXPECT_EQ (valuesOf (input), "150 200 300 400 | 500 625 700 800 | ") << text;
    EXPECT_EQ (namesOf (input), "x y z column_4 ");
    EXPECT_TRUE (input.notes.empty ()) << text;
  }
  EXPECT_EQ (findField (read ("1 2 3\n").cloud, "x")->datatype, pcl::PCLPointField::FLOAT32);
  EXPECT_EQ (error ("1 2 3\n4 5 6\n7,8,9\n"),
             "line 3: its numbers are separated otherwise than those of line 1");
  EXPECT_EQ (error ("1,2,3\n4,5,6\n7;8;9\n"),
             "line 3: its numbers are separated otherwise than those of line 1");
}

TEST_F (Text, TakesDecimalCommas)
{
  for (const char* const text :
       {"1,5;2,25;3,0\n4;-5,5;6e0\n", "1,5 2,25 3,0\n4 -5,5 6e0\n", "1,5\t2,25\t3,0\n4\t-5,5\t6\n",
        "X\tY\tZ\n1,5\t2,25\t3,0\n4\t-5,5\t6,\n", "1,5; 2,25; 3,0;\n4 ;-5,5 ;6\n"}) {
    const InputCloud input = read (text);
    EXPECT_EQ (valuesOf (input), "150 225 300 | 400 -550 600 | ") << text;
    ASSERT_EQ (input.notes.size (), 1u) << text;
    EXPECT_EQ (input.notes[0], "commas taken for decimal points");
  }
  EXPECT_TRUE (std::isnan (valueAt (read ("1,5 2,5 3,5\n1,#QNAN 1 2\n").cloud, "x", 1)));
}

TEST_F (Text, RefusesWhatMayMeanTwoThings)
{
  EXPECT_EQ (error ("1.5 2.5 3.5\n1,5 2,5 3,5\n"),
             "line 2: commas ahead of decimals, but not so from line 1 on");
  EXPECT_EQ (error ("9;8;7\n1,5;2,5;3,5\n1.5;2.5;3.5\n"),
             "line 3: points ahead of decimals, but not so from line 1 on");
  const std::string both = "commas that may stand between numbers or ahead of decimals; write semicolons or "
                           "blanks between the numbers";
  EXPECT_EQ (error ("1,5, 2,25, 3,0\n"), "line 1: " + both);
  EXPECT_EQ (error ("#c\n11,5,2,25,3,07\n"), "line 2: " + both);
  EXPECT_EQ (valuesOf (read ("1,2,3,255,0,10\n")), "100 200 300 25500 0 1000 | ") << "whole numbers";
  // Thousands.
  EXPECT_NE (error ("1,234.5 2,345.6 3,456.7\n"), "");
  EXPECT_NE (error ("1.234,5;2.345,6;3.456,7\n"), "");
}

TEST_F (Text, TakesTheCommonestNumberOfColumns)
{
  const InputCloud origin = read ("694000 5155000 0\n" + lines (20, "1 2 3 4 5 6\n"));
  EXPECT_EQ (origin.size (), 20u);
  EXPECT_EQ (origin.cloud.fields.size (), 6u);
  ASSERT_EQ (origin.notes.size (), 1u);
  EXPECT_EQ (origin.notes[0], "1 line skipped that holds no 6 numbers: line 1");

  const InputCloud counted = read ("20\n" + lines (20, "1 2 3 4 5 6 7\n"));
  EXPECT_EQ (counted.size (), 20u);
  EXPECT_TRUE (counted.notes.empty ());

  EXPECT_EQ (error (lines (4, "1 2 3\n") + lines (20, "1 2 3 4\n")),
             "line 1: not the 4 numbers of most lines; 4 lines differ");
  EXPECT_EQ (error (lines (20, "1 2 3 4\n") + "1 2\n1 2\nx\n"),
             "line 21: not the 4 numbers of most lines; 3 lines differ");
  // Of many lines, some more may be broken.
  const InputCloud many = read (lines (30000, "1 2 3\n") + lines (29, "1 2\n"));
  EXPECT_EQ (many.size (), 30000u);
  EXPECT_EQ (many.notes[0],
             "29 lines skipped that hold no 3 numbers: lines 30001, 30002, 30003, 30004, 30005, ...");
  EXPECT_EQ (error (lines (30000, "1 2 3\n") + lines (31, "1 2\n")),
             "line 30001: not the 3 numbers of most lines; 31 lines differ");
  // No heading has so many lines of numbers.
  EXPECT_NE (error (lines (400, "1 2\n") + lines (410, "1 2 3\n")), "");
}

TEST_F (Text, RefusesTheHeadOfAPtxFile)
{
  const std::string head = "3\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  EXPECT_TRUE (contains (error (head + lines (6, "1 2 3 0.5\n")), "line 1: the head of a PTX file"));
  EXPECT_TRUE (contains (error (head + lines (600, "1 2 3 0.5 1 2 3\n")), "line 1: the head of a PTX file"));
}

TEST_F (Text, TakesNamesFromAHeading)
{
  EXPECT_EQ (namesOf (read ("//X;Y;Z;Rf;Volume density (r=0.01);Nx\n1500\n1;2;3;4;5;6\n")),
             "x y z Rf Volume_density_r_0.01 Nx ");
  EXPECT_EQ (namesOf (read ("\"x\",\"y\",\"z\",\"i\"\n1,2,3,4\n")), "x y z i ");
  EXPECT_EQ (namesOf (read ("X [m]\tY [m]\tZ [m]\tangle of scan\n1 2 3 4\n")), "x y z angle_of_scan ");
  EXPECT_EQ (namesOf (read ("# x y z ring\n1 2 3 4\n")), "x y z ring ");
  EXPECT_EQ (namesOf (read ("# made by some tool\n1 2 3 4\n")), "x y z column_4 ");
  EXPECT_EQ (namesOf (read ("Easting,Northing,Height,x,_,Height\n1,2,3,4,5,6\n")),
             "x y z x_4 column_5 Height ");
  EXPECT_EQ (namesOf (read ("a b c d\nx y z a\n1 2 3 4\n")), "x y z a ") << "the last one counts";
  // The coordinates are where the names say.
  const InputCloud input = read ("time;Z;Y;X\n1;2;3;4\n");
  EXPECT_EQ (namesOf (input), "time z y x ");
  EXPECT_EQ (valueAt (input.cloud, "x", 0), 4);
}

TEST_F (Text, TellsWhichLinesOfAHeadingItSkips)
{
  const InputCloud input = read ("scan of\nthe moon\nx y z\n1 2 3\n");
  ASSERT_EQ (input.notes.size (), 1u);
  EXPECT_EQ (input.notes[0], "2 lines skipped that hold no 3 numbers: lines 1, 2");
}

TEST_F (Text, MayLackValues)
{
  const InputCloud input = read ("1;2;3;;5\n;7;8;9;10\n");
  EXPECT_TRUE (std::isnan (valueAt (input.cloud, "column_4", 0)));
  EXPECT_EQ (valueAt (input.cloud, "column_5", 0), 5);
  EXPECT_TRUE (std::isnan (valueAt (input.cloud, "x", 1)));
  EXPECT_EQ (error (";;;\n"), "no line holds a point (three numbers or more); not understood: line 1");
}

TEST_F (Text, IsRefusedWithoutAnyPoint)
{
  EXPECT_EQ (error ("# nothing\nhere\n1 2\n"),
             "no line holds a point (three numbers or more); not understood: lines 2, 3");
  EXPECT_EQ (error ("\n\n# nothing\n"), "no line holds a point (three numbers or more)");
}
