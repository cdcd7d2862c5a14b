"""Asks a running `seaway serve SCENE --grpc 127.0.0.1:8010` for the water under a hull that this
script sails, and takes a picture. The stubs are made once by

    python3 -m grpc_tools.protoc -I sim_bridge/grpc --python_out=. --grpc_python_out=. \
        seaway/v1/water.proto
"""
import queue
import sys

import grpc
from seaway.v1 import water_pb2 as sea
from seaway.v1 import water_pb2_grpc

address = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1:8010"
water = water_pb2_grpc.WaterStub(grpc.insecure_channel(address))

about = water.Describe(sea.DescribeRequest())
print(f"{about.scene}: H_m0 {about.sea.hm0_realised_m:.2f} m, {len(about.sea.octaves)} octaves")

# The hull is there for as long as this stream is open.
poses = queue.Queue()
placed = water.SubmitPoses(iter(poses.get, None))
batches = queue.Queue()
answers = water.SampleStream(iter(batches.get, None))

for step in range(5):
    t = 0.1 * step
    north = about.anchor_latitude_deg + 5e-6 * step
    east = about.anchor_longitude_deg
    poses.put(sea.PosesRequest(time_s=t, hulls=[sea.HullPose(
        name="mine", vessel=about.vessels[0].name, latitude_deg=north, longitude_deg=east,
        height_m=0.3, heading_deg=0)]))
    hull = next(placed).hulls[0].hull
    batches.put(sea.SampleRequest(
        time_s=t, exclude_hull=hull, shortest_wavelength_m=about.vessels[0].length_m / 4,
        geodetic=sea.GeodeticPoints(latitude_deg=[north, north + 2e-5], longitude_deg=[east] * 2),
        quantities=[sea.QUANTITY_HEIGHT, sea.QUANTITY_SLOPE]))
    answer = next(answers)
    print(f"t {t:.1f} s: {answer.height_m[0]:.3f} m amidships, {answer.height_m[1]:.3f} m forward, "
          f"+- {answer.largest_error_m:.3f} m")

picture = water.Render(sea.RenderRequest(time_s=t, width=320, height=200))
print(f"a picture of {len(picture.picture)} bytes")
poses.put(None)
batches.put(None)
