void main() { write(skyPixel(normalize(pixelRay()))); }
