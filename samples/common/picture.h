#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief A picture that an app draws at its end, if the user asked for it. Needs no display. */
class Picture
{
public:
  /** \brief Finds out early whether the picture will be possible.
   * \param[in] file name of the PNG file to write; empty: no picture is wanted
   * \throws AppError if the file cannot be written, or there is no way to draw (see makeOffscreenWindow ())
   */
  explicit Picture (const std::string& file);

  /** \brief Did the user ask for it? */
  bool wanted () const { return !file_.empty (); }

  /** \brief Draws the panels side by side, more than three of them in two rows, on white, each with its
   * caption and its legend, under a title; writes the file atomically. Back faces of triangles have another
   * tint. Does nothing if no picture is wanted.
   * \param[in] title one line
   * \param[in] panels at least one
   * \param[in] width of the picture, in pixels
   * \param[in] height of the picture, in pixels
   * \throws AppError if drawing or writing fails */
  void draw (const std::string& title, const std::vector<Panel>& panels, int width = 1600,
             int height = 900) const;

private:
  std::string file_;
};

/** \brief Draws a picture as Picture::draw () does.
 * \throws AppError if drawing or writing fails */
void writePicture (const std::string& file, const std::string& title, const std::vector<Panel>& panels,
                   int width, int height);

} // namespace pcl::manifold::apps
