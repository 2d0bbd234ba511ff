// SPDX-License-Identifier: MIT
// Written by test_golden.c, which says how.
{"sea: default", 0x12154b2e0ac6ca13u}, {"sea: storm and swell", 0xb2b455e31a884c3du},
    {"sea: shallow, looping", 0x13dbdf07bdac5647u}, {"sea: Phillips", 0xb64238b7267513a3u},
    {"sea: cosines in a current", 0x676a0515bd7990e5u}, {"sea: cosines", 0xedf01246aa03b085u},
    {"sea: exp-cosine", 0x10a34ebe1a7f69b9u}, {"sea: textures", 0xd8cc45fec179a541u}, {"tiles", 0x566783766fb22d7fu},
    {"ground: pond", 0x8881f5b8a1611b98u}, {"ground: island", 0xe06785a06e4fdf37u},
    {"ground: raster", 0xc0268bdd2dd29f8du}, {"nested grid", 0xfa5e0e96a449be3au},
    {"model: pond-ground", 0xa01b0210c68621a2u}, {"model: pond-wood", 0xd6ec124e4d7fab41u},
    {"model: house", 0x52aa980ef88e2be2u}, {"model: boat", 0x7dd49737e1731cdfu}, {"model: stick", 0x6d188ade3b1f2b9cu},
    {"model: tree", 0x82297b85edbd8945u}, {"model: conifer", 0x558d621dba20f261u},
    {"model: reeds", 0x0121dd7eabb5eb10u}, {"model: jetty", 0xc98429356425d7e1u}, {"model: rock", 0xc96ec6a37067a78du},
