#pragma once

namespace planetree::tool {

/// Puts something in the place of each standard stream that the tool was started without, as
/// `2>&-` does in a shell. Without it the next file that is opened would get the free number, and
/// what is said on standard error would stand in the middle of a picture. Reading from the stand-in
/// fails, and so does writing to it, as with a closed stream. To be called first of all.
void occupyClosedStreams() noexcept;

}  // namespace planetree::tool
