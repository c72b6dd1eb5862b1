import type { TransferWing } from '../../app/transfer/wing';
import { useWing } from '../context';

/** The transfer wing, for its own panels. */
export const useTransfer = (): TransferWing => useWing<TransferWing>('transfer');
