"""blender -b --python in_blender.py -- JOBS.json: opens models, counts, draws silhouettes.

Each job is {"model", "picture", "camera"}; Blender's counts come out as a line of JSON each, after
the word COUNTS. The silhouette is the picture's opacity.
"""
import json
import math
import sys
from pathlib import Path

import numpy

numpy.bool = bool  # glTF's importer of Blender 3.4 asks for it, numpy 1.24 has it no more
import bpy  # noqa: E402
from mathutils import Vector  # noqa: E402


def z_up(p):
    return Vector((p[0], -p[2], p[1]))


def counts():
    objects = [o for o in bpy.data.objects if o.type == "MESH"]
    return {"nodes": len(bpy.data.objects),
            "meshes": len({o.data.name for o in objects}),
            "materials": len({s.material.name for o in objects for s in o.material_slots}),
            "triangles": sum(len(p.vertices) - 2 for o in objects for p in o.data.polygons)}


def add_camera(camera):
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "VERTICAL"
    lens.angle_y = math.radians(camera["degrees"])
    lens.clip_end = camera["far"]
    eye = bpy.data.objects.new("camera", lens)
    eye.location = z_up(camera["eye"])
    towards = z_up(camera["target"]) - eye.location
    eye.rotation_euler = towards.to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(eye)
    bpy.context.scene.camera = eye


def draw(job):
    scene = bpy.context.scene
    add_camera(job["camera"])
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 4
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.cycles.pixel_filter_type = "BOX"
    scene.view_layers[0].material_override = bpy.data.materials.new("plain")
    scene.render.film_transparent = True
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
    scene.render.resolution_x, scene.render.resolution_y = job["camera"]["size"]
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = job["picture"]
    bpy.ops.render.render(write_still=True)


for a_job in json.loads(Path(sys.argv[-1]).read_text()):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=a_job["model"])
    print("COUNTS", json.dumps(counts()), flush=True)
    draw(a_job)
