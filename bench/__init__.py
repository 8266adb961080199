"""What the product costs: instructions, bytes, throughput, and the time a person waits."""
