// SPDX-License-Identifier: MIT
// The OpenGL functions that this folder calls, as one table of pointers. It is filled by the host's get_proc_address
// hook where there is one, else by libepoxy, so a host with a loader or a capture layer of its own sees every call.
// A function that a newer file calls must be named in one of the lists and among the macros below:
// tests/layers/check.sh looks.
#ifndef BOLAN_GL_LOADER_H
#define BOLAN_GL_LOADER_H

#include <epoxy/gl.h>
#include <stdbool.h>

// In every OpenGL 3.3 and OpenGL ES 3.0.
#define GL_NEEDED(X)                                                                                                   \
    X(ActiveTexture) X(CopyBufferSubData)                                                                              \
    X(DeleteSamplers) X(GenSamplers) X(IsTexture) X(SamplerParameteri) X(StencilFuncSeparate)                          \
    X(StencilOpSeparate)                                                                                               \
    X(AttachShader) X(BindBuffer) X(BindBufferBase) X(BindBufferRange) X(BindFramebuffer) X(BindSampler)               \
        X(BindTexture) X(BindVertexArray) X(BlendEquation) X(BlendEquationSeparate) X(BlendFunc) X(BlendFuncSeparate)  \
            X(BlitFramebuffer) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) X(Clear) X(ClearColor)         \
                X(ColorMask) X(CompileShader) X(CreateProgram) X(CreateShader) X(CullFace) X(DeleteBuffers)            \
                    X(DeleteFramebuffers) X(DeleteProgram) X(DeleteQueries) X(DeleteShader) X(DeleteTextures)          \
                        X(DeleteVertexArrays) X(DepthFunc) X(DepthMask) X(Disable) X(DrawArrays) X(DrawBuffers)        \
                            X(DrawElements) X(Enable) X(EnableVertexAttribArray) X(Finish) X(FramebufferTexture2D)     \
                                X(FramebufferTextureLayer) X(FrontFace) X(GenBuffers) X(GenFramebuffers) X(GenQueries) \
                                    X(GenTextures) X(GenVertexArrays) X(GenerateMipmap) X(GetActiveUniform)            \
                                        X(GetBooleanv)                                                                 \
                                        X(GetBufferParameteri64v) X(GetFloatv) X(GetFramebufferAttachmentParameteriv)  \
                                            X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramiv) X(GetQueryObjectuiv)   \
                                                X(GetQueryiv) X(GetShaderInfoLog) X(GetShaderiv) X(GetString)          \
                                                    X(GetStringi) X(GetUniformBlockIndex) X(GetUniformLocation)        \
                                                        X(IsEnabled) X(IsFramebuffer) X(IsProgram) X(LineWidth)        \
                                                            X(LinkProgram) X(PixelStorei) X(ReadBuffer) X(ReadPixels)  \
                                                                X(Scissor) X(ShaderSource) X(TexImage2D) X(TexImage3D) \
                                                                    X(TexParameterf) X(TexParameteri) X(TexSubImage2D) \
                                                                        X(TexSubImage3D) X(Uniform1f) X(Uniform1i)     \
                                                                            X(Uniform2f) X(Uniform4f) X(Uniform4fv)    \
                                                                                X(UniformBlockBinding) X(UseProgram)   \
                                                                                    X(VertexAttribPointer) X(Viewport)

// In some versions only; gl_caps tells which may be called.
#define GL_OPTIONAL(X)                                                                                                \
    X(BindImageTexture) X(DispatchCompute) X(MemoryBarrier) X(TexStorage3D) X(TextureView) X(TextureViewEXT)          \
    X(TextureViewOES)                                                                                                 \
    X(BlendEquationSeparatei)                                                                                         \
    X(GetTextureParameteriv)                                                                                          \
    X(BlendEquationi) X(BlendFuncSeparatei) X(ClampColor) X(ClearDepth) X(ClearDepthf) X(ClipControl)                 \
        X(ClipControlEXT) X(ColorMaski) X(DebugMessageCallback) X(DebugMessageCallbackKHR) X(DepthRange)              \
            X(DepthRangeIndexed) X(DepthRangef) X(Disablei) X(Enablei) X(GetDoublev) X(GetPointerv) X(GetPointervKHR) \
                X(GetQueryObjectui64v) X(GetTexLevelParameteriv) X(IsEnabledi) X(PauseTransformFeedback)              \
                    X(PixelTransferf) X(PolygonMode) X(ProvokingVertex) X(QueryCounter) X(ResumeTransformFeedback)    \
                        X(ScissorIndexedv) X(ViewportIndexedfv)

#define GL_POINTER(name) __typeof__(epoxy_gl##name) name;
typedef struct gl_functions {
    GL_NEEDED(GL_POINTER)
    GL_OPTIONAL(GL_POINTER)
} gl_functions;
#undef GL_POINTER
extern gl_functions bolan_gl_functions;

// Fills the table when the hook has changed since the last call, or at the first. Thread-safe.
// NULL, or the name of the first needed function that the hook does not know.
const char *bolan_gl_load(void);

// Whether the current context is OpenGL ES.
bool bolan_gl_is_es(void);
// The version of the current context: 33 for OpenGL 3.3; 0 without one.
int bolan_gl_version(void);
bool bolan_gl_has_extension(const char *name);

#undef glActiveTexture
#define glActiveTexture bolan_gl_functions.ActiveTexture
#undef glAttachShader
#define glAttachShader bolan_gl_functions.AttachShader
#undef glBindBuffer
#define glBindBuffer bolan_gl_functions.BindBuffer
#undef glBindBufferBase
#define glBindBufferBase bolan_gl_functions.BindBufferBase
#undef glBindBufferRange
#define glBindBufferRange bolan_gl_functions.BindBufferRange
#undef glBindFramebuffer
#define glBindFramebuffer bolan_gl_functions.BindFramebuffer
#undef glBindImageTexture
#define glBindImageTexture bolan_gl_functions.BindImageTexture
#undef glBindSampler
#define glBindSampler bolan_gl_functions.BindSampler
#undef glBindTexture
#define glBindTexture bolan_gl_functions.BindTexture
#undef glBindVertexArray
#define glBindVertexArray bolan_gl_functions.BindVertexArray
#undef glBlendEquation
#define glBlendEquation bolan_gl_functions.BlendEquation
#undef glBlendEquationSeparate
#define glBlendEquationSeparate bolan_gl_functions.BlendEquationSeparate
#undef glBlendEquationSeparatei
#define glBlendEquationSeparatei bolan_gl_functions.BlendEquationSeparatei
#undef glBlendEquationi
#define glBlendEquationi bolan_gl_functions.BlendEquationi
#undef glBlendFunc
#define glBlendFunc bolan_gl_functions.BlendFunc
#undef glBlendFuncSeparate
#define glBlendFuncSeparate bolan_gl_functions.BlendFuncSeparate
#undef glBlendFuncSeparatei
#define glBlendFuncSeparatei bolan_gl_functions.BlendFuncSeparatei
#undef glBlitFramebuffer
#define glBlitFramebuffer bolan_gl_functions.BlitFramebuffer
#undef glBufferData
#define glBufferData bolan_gl_functions.BufferData
#undef glBufferSubData
#define glBufferSubData bolan_gl_functions.BufferSubData
#undef glCheckFramebufferStatus
#define glCheckFramebufferStatus bolan_gl_functions.CheckFramebufferStatus
#undef glClampColor
#define glClampColor bolan_gl_functions.ClampColor
#undef glClear
#define glClear bolan_gl_functions.Clear
#undef glClearColor
#define glClearColor bolan_gl_functions.ClearColor
#undef glClearDepth
#define glClearDepth bolan_gl_functions.ClearDepth
#undef glClearDepthf
#define glClearDepthf bolan_gl_functions.ClearDepthf
#undef glClipControl
#define glClipControl bolan_gl_functions.ClipControl
#undef glClipControlEXT
#define glClipControlEXT bolan_gl_functions.ClipControlEXT
#undef glColorMask
#define glColorMask bolan_gl_functions.ColorMask
#undef glColorMaski
#define glColorMaski bolan_gl_functions.ColorMaski
#undef glCompileShader
#define glCompileShader bolan_gl_functions.CompileShader
#undef glCopyBufferSubData
#define glCopyBufferSubData bolan_gl_functions.CopyBufferSubData
#undef glCreateProgram
#define glCreateProgram bolan_gl_functions.CreateProgram
#undef glCreateShader
#define glCreateShader bolan_gl_functions.CreateShader
#undef glCullFace
#define glCullFace bolan_gl_functions.CullFace
#undef glDebugMessageCallback
#define glDebugMessageCallback bolan_gl_functions.DebugMessageCallback
#undef glDebugMessageCallbackKHR
#define glDebugMessageCallbackKHR bolan_gl_functions.DebugMessageCallbackKHR
#undef glDeleteBuffers
#define glDeleteBuffers bolan_gl_functions.DeleteBuffers
#undef glDeleteFramebuffers
#define glDeleteFramebuffers bolan_gl_functions.DeleteFramebuffers
#undef glDeleteProgram
#define glDeleteProgram bolan_gl_functions.DeleteProgram
#undef glDeleteQueries
#define glDeleteQueries bolan_gl_functions.DeleteQueries
#undef glDeleteSamplers
#define glDeleteSamplers bolan_gl_functions.DeleteSamplers
#undef glDeleteShader
#define glDeleteShader bolan_gl_functions.DeleteShader
#undef glDeleteTextures
#define glDeleteTextures bolan_gl_functions.DeleteTextures
#undef glDeleteVertexArrays
#define glDeleteVertexArrays bolan_gl_functions.DeleteVertexArrays
#undef glDepthFunc
#define glDepthFunc bolan_gl_functions.DepthFunc
#undef glDepthMask
#define glDepthMask bolan_gl_functions.DepthMask
#undef glDepthRange
#define glDepthRange bolan_gl_functions.DepthRange
#undef glDepthRangeIndexed
#define glDepthRangeIndexed bolan_gl_functions.DepthRangeIndexed
#undef glDepthRangef
#define glDepthRangef bolan_gl_functions.DepthRangef
#undef glDisable
#define glDisable bolan_gl_functions.Disable
#undef glDisablei
#define glDisablei bolan_gl_functions.Disablei
#undef glDispatchCompute
#define glDispatchCompute bolan_gl_functions.DispatchCompute
#undef glDrawArrays
#define glDrawArrays bolan_gl_functions.DrawArrays
#undef glDrawBuffers
#define glDrawBuffers bolan_gl_functions.DrawBuffers
#undef glDrawElements
#define glDrawElements bolan_gl_functions.DrawElements
#undef glEnable
#define glEnable bolan_gl_functions.Enable
#undef glEnableVertexAttribArray
#define glEnableVertexAttribArray bolan_gl_functions.EnableVertexAttribArray
#undef glEnablei
#define glEnablei bolan_gl_functions.Enablei
#undef glFinish
#define glFinish bolan_gl_functions.Finish
#undef glFramebufferTexture2D
#define glFramebufferTexture2D bolan_gl_functions.FramebufferTexture2D
#undef glFramebufferTextureLayer
#define glFramebufferTextureLayer bolan_gl_functions.FramebufferTextureLayer
#undef glFrontFace
#define glFrontFace bolan_gl_functions.FrontFace
#undef glGenBuffers
#define glGenBuffers bolan_gl_functions.GenBuffers
#undef glGenFramebuffers
#define glGenFramebuffers bolan_gl_functions.GenFramebuffers
#undef glGenQueries
#define glGenQueries bolan_gl_functions.GenQueries
#undef glGenSamplers
#define glGenSamplers bolan_gl_functions.GenSamplers
#undef glGenTextures
#define glGenTextures bolan_gl_functions.GenTextures
#undef glGenVertexArrays
#define glGenVertexArrays bolan_gl_functions.GenVertexArrays
#undef glGenerateMipmap
#define glGenerateMipmap bolan_gl_functions.GenerateMipmap
#undef glGetActiveUniform
#define glGetActiveUniform bolan_gl_functions.GetActiveUniform
#undef glGetBooleanv
#define glGetBooleanv bolan_gl_functions.GetBooleanv
#undef glGetBufferParameteri64v
#define glGetBufferParameteri64v bolan_gl_functions.GetBufferParameteri64v
#undef glGetDoublev
#define glGetDoublev bolan_gl_functions.GetDoublev
#undef glGetFloatv
#define glGetFloatv bolan_gl_functions.GetFloatv
#undef glGetFramebufferAttachmentParameteriv
#define glGetFramebufferAttachmentParameteriv bolan_gl_functions.GetFramebufferAttachmentParameteriv
#undef glGetIntegerv
#define glGetIntegerv bolan_gl_functions.GetIntegerv
#undef glGetPointerv
#define glGetPointerv bolan_gl_functions.GetPointerv
#undef glGetPointervKHR
#define glGetPointervKHR bolan_gl_functions.GetPointervKHR
#undef glGetProgramInfoLog
#define glGetProgramInfoLog bolan_gl_functions.GetProgramInfoLog
#undef glGetProgramiv
#define glGetProgramiv bolan_gl_functions.GetProgramiv
#undef glGetQueryObjectui64v
#define glGetQueryObjectui64v bolan_gl_functions.GetQueryObjectui64v
#undef glGetQueryObjectuiv
#define glGetQueryObjectuiv bolan_gl_functions.GetQueryObjectuiv
#undef glGetQueryiv
#define glGetQueryiv bolan_gl_functions.GetQueryiv
#undef glGetShaderInfoLog
#define glGetShaderInfoLog bolan_gl_functions.GetShaderInfoLog
#undef glGetShaderiv
#define glGetShaderiv bolan_gl_functions.GetShaderiv
#undef glGetStringi
#define glGetStringi bolan_gl_functions.GetStringi
#undef glGetString
#define glGetString bolan_gl_functions.GetString
#undef glGetTexLevelParameteriv
#define glGetTexLevelParameteriv bolan_gl_functions.GetTexLevelParameteriv
#undef glGetTextureParameteriv
#define glGetTextureParameteriv bolan_gl_functions.GetTextureParameteriv
#undef glGetUniformBlockIndex
#define glGetUniformBlockIndex bolan_gl_functions.GetUniformBlockIndex
#undef glGetUniformLocation
#define glGetUniformLocation bolan_gl_functions.GetUniformLocation
#undef glIsEnabled
#define glIsEnabled bolan_gl_functions.IsEnabled
#undef glIsEnabledi
#define glIsEnabledi bolan_gl_functions.IsEnabledi
#undef glIsFramebuffer
#define glIsFramebuffer bolan_gl_functions.IsFramebuffer
#undef glIsProgram
#define glIsProgram bolan_gl_functions.IsProgram
#undef glIsTexture
#define glIsTexture bolan_gl_functions.IsTexture
#undef glLineWidth
#define glLineWidth bolan_gl_functions.LineWidth
#undef glLinkProgram
#define glLinkProgram bolan_gl_functions.LinkProgram
#undef glMemoryBarrier
#define glMemoryBarrier bolan_gl_functions.MemoryBarrier
#undef glPauseTransformFeedback
#define glPauseTransformFeedback bolan_gl_functions.PauseTransformFeedback
#undef glPixelStorei
#define glPixelStorei bolan_gl_functions.PixelStorei
#undef glPixelTransferf
#define glPixelTransferf bolan_gl_functions.PixelTransferf
#undef glPolygonMode
#define glPolygonMode bolan_gl_functions.PolygonMode
#undef glProvokingVertex
#define glProvokingVertex bolan_gl_functions.ProvokingVertex
#undef glQueryCounter
#define glQueryCounter bolan_gl_functions.QueryCounter
#undef glReadBuffer
#define glReadBuffer bolan_gl_functions.ReadBuffer
#undef glReadPixels
#define glReadPixels bolan_gl_functions.ReadPixels
#undef glResumeTransformFeedback
#define glResumeTransformFeedback bolan_gl_functions.ResumeTransformFeedback
#undef glSamplerParameteri
#define glSamplerParameteri bolan_gl_functions.SamplerParameteri
#undef glScissor
#define glScissor bolan_gl_functions.Scissor
#undef glScissorIndexedv
#define glScissorIndexedv bolan_gl_functions.ScissorIndexedv
#undef glShaderSource
#define glShaderSource bolan_gl_functions.ShaderSource
#undef glStencilFuncSeparate
#define glStencilFuncSeparate bolan_gl_functions.StencilFuncSeparate
#undef glStencilOpSeparate
#define glStencilOpSeparate bolan_gl_functions.StencilOpSeparate
#undef glTexImage2D
#define glTexImage2D bolan_gl_functions.TexImage2D
#undef glTexImage3D
#define glTexImage3D bolan_gl_functions.TexImage3D
#undef glTexParameterf
#define glTexParameterf bolan_gl_functions.TexParameterf
#undef glTexParameteri
#define glTexParameteri bolan_gl_functions.TexParameteri
#undef glTexStorage3D
#define glTexStorage3D bolan_gl_functions.TexStorage3D
#undef glTexSubImage2D
#define glTexSubImage2D bolan_gl_functions.TexSubImage2D
#undef glTexSubImage3D
#define glTexSubImage3D bolan_gl_functions.TexSubImage3D
#undef glTextureView
#define glTextureView bolan_gl_functions.TextureView
#undef glTextureViewEXT
#define glTextureViewEXT bolan_gl_functions.TextureViewEXT
#undef glTextureViewOES
#define glTextureViewOES bolan_gl_functions.TextureViewOES
#undef glUniform1f
#define glUniform1f bolan_gl_functions.Uniform1f
#undef glUniform1i
#define glUniform1i bolan_gl_functions.Uniform1i
#undef glUniform2f
#define glUniform2f bolan_gl_functions.Uniform2f
#undef glUniform4f
#define glUniform4f bolan_gl_functions.Uniform4f
#undef glUniform4fv
#define glUniform4fv bolan_gl_functions.Uniform4fv
#undef glUniformBlockBinding
#define glUniformBlockBinding bolan_gl_functions.UniformBlockBinding
#undef glUseProgram
#define glUseProgram bolan_gl_functions.UseProgram
#undef glVertexAttribPointer
#define glVertexAttribPointer bolan_gl_functions.VertexAttribPointer
#undef glViewport
#define glViewport bolan_gl_functions.Viewport
#undef glViewportIndexedfv
#define glViewportIndexedfv bolan_gl_functions.ViewportIndexedfv

#endif
