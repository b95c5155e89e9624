# Writes the blocks of code of a Markdown page to files, as a reader of the page would: a block is named by
# `NAME` at the start of the line before it, or by a comment in its first line (// NAME.cpp, # CMakeLists.txt).
# A block of C++ with a line "..." leaves out what every program has: it is written as fragment_N.cpp, with a
# main that has read the points of its first argument to `cloud`. Other blocks of C++ need a name.
#
#   awk -v folder=FOLDER -f blocks.awk PAGE.md
function fail(text) { printf "error: %s:%d: %s\n", FILENAME, FNR, text > "/dev/stderr"; failed = 1; exit 1 }

/^```/ && inside {
  inside = 0
  if (body == "" || (kind != "cpp" && name == ""))
    next
  if (kind == "cpp" && name == "" && match(body, /(^|\n)\.\.\.\n/)) {
    name = "fragment_" ++fragments ".cpp"
    open = "int main (int, char** argv)\n{\n" \
      "  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);\n" \
      "  if (pcl::io::loadPCDFile (argv[1], *cloud) < 0)\n    return 1;\n"
    body = "#include <pcl/io/pcd_io.h>\n#include <iostream>\n" substr(body, 1, RSTART - (RSTART > 1 ? 0 : 1)) open \
      substr(body, RSTART + RLENGTH) "}\n"
  }
  if (name == "")
    fail("a block of C++ without a name in the line before it and without a line ... in it")
  printf "%s", body > (folder "/" name)
  close(folder "/" name)
  next
}

/^```/ {
  inside = 1
  kind = substr($0, 4)
  body = name = ""
  if (match(before, /^`[A-Za-z0-9_]+\.(cpp|txt)`/))
    name = substr(before, 2, RLENGTH - 2)
  next
}

inside {
  if (body == "" && name == "" && ($1 == "//" || $1 == "#") && $2 ~ /^[A-Za-z0-9_]+\.(cpp|txt)$/)
    name = $2
  body = body $0 "\n"
}

{ before = $0 }

END {
  if (inside && !failed)
    fail("a block without an end")
}
