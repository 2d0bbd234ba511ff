// SPDX-License-Identifier: MIT
// Written by test_golden.c, which says how.
{"sea: default", 0xa9a1af9428a9d18cu}, {"sea: storm and swell", 0x157a21bdc8d6acb9u},
    {"sea: shallow, looping", 0x2c8d8428027cb649u}, {"sea: Phillips", 0xfe07f1a21f935e82u},
    {"sea: order 2", 0x6bdc9069f2c38e1au},
    {"sea: cosines in a current", 0x880563e5aedbb477u}, {"sea: cosines", 0xfcbb8d3d1c73f219u},
    {"sea: exp-cosine", 0x4c77e59da171ec39u}, {"sea: textures", 0x71e7e5d87d7a95bfu}, {"tiles", 0x364aadc01c581294u},
    {"ground: pond", 0x8881f5b8a1611b98u}, {"ground: island", 0xe06785a06e4fdf37u},
    {"ground: raster", 0xc0268bdd2dd29f8du}, {"nested grid", 0xfa5e0e96a449be3au},
    {"model: pond-ground", 0xa01b0210c68621a2u}, {"model: pond-wood", 0xd6ec124e4d7fab41u},
    {"model: house", 0x52aa980ef88e2be2u}, {"model: boat", 0x7dd49737e1731cdfu}, {"model: stick", 0x6d188ade3b1f2b9cu},
    {"model: tree", 0x82297b85edbd8945u}, {"model: conifer", 0x558d621dba20f261u},
    {"model: reeds", 0x0121dd7eabb5eb10u}, {"model: jetty", 0xc98429356425d7e1u}, {"model: rock", 0xc96ec6a37067a78du},
