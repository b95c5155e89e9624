#include "graph_models.h"

#include <app_error.h>
#include <files/number_text.h>
#include <generate/catalogue.h>
#include <generate/sampling.h>
#include <sample_input.h>

#include <filesystem>
#include <sstream>
#include <string_view>

namespace benchmark {
namespace {

template <typename Number>
Number
parse (const std::string& text)
{
  Number number{};
  if (!pcl::manifold::apps::parseNumber (std::string_view (text), number))
    throw pcl::manifold::apps::UsageError (text, "is no number");
  return number;
}

} // namespace

std::vector<std::string>
splitAtCommas (const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream stream (list);
  for (std::string part; std::getline (stream, part, ',');)
    if (!part.empty ())
      parts.push_back (part);
  return parts;
}

std::vector<int>
numbersOf (const std::string& list)
{
  std::vector<int> numbers;
  for (const std::string& part : splitAtCommas (list)) {
    const std::size_t dash = part.find ('-', 1);
    const int first = parse<int> (part.substr (0, dash));
    const int last = dash == std::string::npos ? first : parse<int> (part.substr (dash + 1));
    for (int number = first; number <= last; ++number)
      numbers.push_back (number);
  }
  return numbers;
}

std::vector<GraphModel>
modelsOfFiles (const std::string& files)
{
  std::vector<GraphModel> models;
  for (const std::string& file : splitAtCommas (files))
    models.push_back ({std::filesystem::path (file).stem ().string (), [file] {
                         namespace apps = pcl::manifold::apps;
                         return apps::pointsOf (apps::readCloud (file, apps::Reading::LAX));
                       }});
  return models;
}

std::vector<GraphModel>
generatedModels (const std::string& shapes, const std::string& sizes, bool even, std::uint64_t seed)
{
  std::vector<GraphModel> models;
  for (const std::string& name : splitAtCommas (shapes)) {
    const generate::Shape shape = generate::shapeByName (name);
    for (const std::string& size : splitAtCommas (sizes)) {
      const auto count = static_cast<std::size_t> (parse<double> (size));
      models.push_back ({name + (even ? " even " : " random ") + size, [shape, count, even, seed] {
                           const generate::LabelledCloud sample =
                             even ? generate::blueNoise (shape, generate::spacingFor (shape, count), seed)
                                  : generate::uniform (shape, count, seed);
                           auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> ();
                           cloud->resize (sample.size ());
                           for (std::size_t i = 0; i < sample.size (); ++i)
                             (*cloud)[i].getVector3fMap () = sample.points[i].cast<float> ();
                           return cloud;
                         }});
    }
  }
  return models;
}

} // namespace benchmark
