#include "judge/trace/gl_calls.hpp"

namespace umbral::grader {
namespace {

/// Functions whose names begin so, and what the core profile has instead. A test compares this list with the headers of
/// both profiles.
struct Removed {
    std::string_view beginnings;  ///< separated by spaces; one with '$' at its end is a whole name
    const char* instead;
};

constexpr const char* in_buffers = "keep the vertices in a buffer, and draw them with glDrawArrays or glDrawElements";
constexpr const char* in_attributes = "declare attributes with glVertexAttribPointer and glEnableVertexAttribArray";
constexpr const char* in_uniforms = "compute matrices yourself, and hand them to the program as uniforms";
constexpr const char* in_shaders = "a shader does this now";
constexpr const char* in_textures = "draw a textured rectangle, or copy between framebuffers";
constexpr const char* gone = "the core profile has nothing of the kind";

constexpr Removed removed[] = {
    {"glBegin$ glEnd$ glVertex2 glVertex3 glVertex4 glVertexP2 glVertexP3 glVertexP4 glNormal3 glNormalP3 glColor3 "
     "glColor4 glColorP3 glColorP4 "
     "glSecondaryColor3 glSecondaryColorP3 glTexCoord1 glTexCoord2 glTexCoord3 glTexCoord4 glTexCoordP glMultiTexCoord "
     "glFogCoordd glFogCoordf glIndexd "
     "glIndexf glIndexi glIndexs glIndexub glEdgeFlag$ glEdgeFlagv$ glRect glArrayElement$",
     in_buffers},
    {"glNewList$ glEndList$ glCallList glGenLists$ glDeleteLists$ glIsList$ glListBase$", in_buffers},
    {"glVertexPointer$ glNormalPointer$ glColorPointer$ glSecondaryColorPointer$ glTexCoordPointer$ glFogCoordPointer$ "
     "glIndexPointer$ glEdgeFlagPointer$ "
     "glInterleavedArrays$ glEnableClientState$ glDisableClientState$ glClientActiveTexture$",
     in_attributes},
    {"glMatrixMode$ glLoadIdentity$ glLoadMatrix glLoadTranspose glMultMatrix glMultTranspose glPushMatrix$ "
     "glPopMatrix$ glRotate glScaled$ glScalef$ "
     "glTranslate glFrustum$ glOrtho$",
     in_uniforms},
    {"glLight glMaterial glColorMaterial$ glGetLight glGetMaterial glShadeModel$ glFogf glFogi glTexEnv glGetTexEnv "
     "glTexGen glGetTexGen glAlphaFunc$ "
     "glClipPlane$ glGetClipPlane$ glMap1 glMap2 glMapGrid glGetMap glGetnMap glEvalCoord glEvalMesh glEvalPoint",
     in_shaders},
    {"glBitmap$ glDrawPixels$ glCopyPixels$ glPixelZoom$ glPixelTransfer glPixelMap glGetPixelMap glGetnPixelMap "
     "glRasterPos glWindowPos",
     in_textures},
    {"glPushAttrib$ glPopAttrib$ glPushClientAttrib$ glPopClientAttrib$ glPushName$ glPopName$ glLoadName$ "
     "glInitNames$ glPassThrough$ glRenderMode$ "
     "glSelectBuffer$ glFeedbackBuffer$ glAccum$ glClearAccum$ glClearIndex$ glIndexMask$ glLineStipple$ "
     "glPolygonStipple$ glGetPolygonStipple$ "
     "glGetnPolygonStipple$ glPrioritizeTextures$ glAreTexturesResident$ glColorTable glColorSubTable$ glCopyColor "
     "glGetColorTable glGetnColorTable$ "
     "glConvolution glCopyConvolution glGetConvolution glGetnConvolution glSeparableFilter glGetSeparable "
     "glGetnSeparable glHistogram$ glGetHistogram "
     "glGetnHistogram$ glResetHistogram$ glMinmax$ glGetMinmax glGetnMinmax$ glResetMinmax$",
     gone}};

bool matches(std::string_view name, std::string_view beginning)
{
    return beginning.ends_with('$') ? name == beginning.substr(0, beginning.size() - 1) : name.starts_with(beginning);
}

}

const char* instead_of_deprecated(std::string_view name)
{
    for (const Removed& group : removed)
        for (std::string_view rest = group.beginnings; !rest.empty();) {
            const std::string_view beginning = rest.substr(0, rest.find(' '));
            if (matches(name, beginning)) return group.instead;
            rest.remove_prefix(std::min(beginning.size() + 1, rest.size()));
        }
    return nullptr;
}

}
