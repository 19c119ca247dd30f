// An address, or a part of one, in plain letters. It may come from anybody, and then it is as it stands
// where its per cent signs encode nothing.

export function decoded(address: string): string {
  try {
    return decodeURIComponent(address);
  } catch {
    return address;
  }
}
